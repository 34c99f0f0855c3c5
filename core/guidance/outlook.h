#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/sighting_plan.h"
#include "core/session/measurement.h"
#include "core/session/protocol_progress.h"

namespace alidade {

// Part of a protocol has been sighted. What is U of Δd after the rest of the protocol, and after one or
// several more rounds in every position (there and back in turn)? Which U does the verdict need, and which
// number of rounds reaches it? Scatter between rounds decreases as 1/√n; errors common to all rounds stay.

/// U of Δd, mm, at the coverage of the session.
struct ExpandedPair {
  double ofFit = 0;                       ///< fit only
  std::optional<double> asMeasured = {};  ///< with every effect of the catalogue; absent with very many rows
};

/// The expected U after a number of rounds in every position, beyond those of the protocol.
struct RoundsAhead {
  int rounds = 0;
  ExpandedPair expanded;
};

struct Outlook {
  std::optional<ExpandedPair> now = {};  ///< U of the existing readings; absent without both positions
  /// U after the rest of the protocol, then after 1, 2, … further rounds: at least two, and up to eight if
  /// these lead to a verdict. Empty if the completed protocol yields no Δd.
  std::vector<RoundsAhead> ahead = {};
  std::optional<ExpandedPair> limit = {};  ///< U for infinitely many rounds: the part that more rounds
                                           ///< cannot reduce
  /// The U that a verdict needs, ||Δd| − tolerance|, mm, fit only and measured, and the resulting verdict:
  /// within the tolerance or beyond it. Absent without Δd or a tolerance of Δd.
  std::optional<ExpandedPair> needed = {};
  bool isWithin = true;
  bool isTorn = false;  ///< Δd, fit only, and Δd, measured, are on different sides of the tolerance

  /// Whether U is small enough, fit only as well as measured.
  bool isEnough(const ExpandedPair& expanded) const;
  /// The least sufficient number of rounds beyond the protocol; absent if none of `ahead` suffices.
  std::optional<int> roundsNeeded() const;
  /// Alternatives if more rounds do not suffice (`attainableUncertainties`); the first has no further
  /// measure.
  std::vector<AttainableUncertainty> instead = {};
  SessionEffort whole = {};  ///< effort of the complete protocol
};

/// `fit` and `diagnosis` are those of the measurement. If `diagnosis` is null, Δd, fit only, replaces Δd,
/// measured. On a stop request, returns early with fewer results.
Outlook outlookOf(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                  const SightingProtocol& protocol, const ProtocolProgress& progress,
                  const std::stop_token& stop = {});

/// The measurement after `rounds` further rounds beyond the complete protocol: its places on the arcs fitted
/// so far, with readings free of errors. Absent before a pointing zero is known.
std::optional<Measurement> carriedOut(const Measurement& measurement, const SessionFit& fit,
                                      const SightingProtocol& protocol, const ProtocolProgress& progress,
                                      int rounds);

}  // namespace alidade
