#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/session/measurement.h"
#include "core/session/protocol_progress.h"

namespace alidade {

// The situation: part of a protocol has been sighted. Which U will Δd have once the rest of it is, which
// after one more round in every position (back and there in turn), or several; which does the verdict need,
// and is there a number of rounds that comes to it? What scatters from round to round goes down as 1/√n, what
// is the same in each stays.

/// U of Δd, mm, at the coverage of the session.
struct ExpandedPair {
  double ofFit = 0;                       ///< of the fit alone
  std::optional<double> asMeasured = {};  ///< with every effect of the catalogue; absent with very many rows
};

/// Once so many rounds are there, in every position, beyond those of the protocol.
struct RoundsAhead {
  int rounds = 0;
  ExpandedPair expanded;
};

struct Outlook {
  std::optional<ExpandedPair> now = {};  ///< of what is there; absent without both positions
  /// First with what is left of the protocol, then with ever more rounds, as far as they matter. Empty where
  /// the protocol, carried out, does not give Δd.
  std::vector<RoundsAhead> ahead = {};
  std::optional<ExpandedPair> limit = {};  ///< with rounds without end: what more rounds cannot take away
  /// With a tolerance of Δd, and Δd: the U that a verdict needs of the fit and as measured, ||Δd| −
  /// tolerance|, mm; what it would then be: within the tolerance or beyond it.
  std::optional<ExpandedPair> needed = {};
  bool isWithin = true;
  bool isTorn = false;  ///< Δd of the fit is within the tolerance and as measured it is not, or the reverse

  /// Both accounts call it enough.
  bool isEnough(const ExpandedPair& expanded) const;
  /// How many rounds beyond the protocol are enough; absent where none of `ahead` is.
  std::optional<int> roundsNeeded() const;
  /// Instead of more rounds, where these do not do (`attainableUncertainties`); the first with nothing more.
  std::vector<AttainableUncertainty> instead = {};
};

struct OutlookOptions {
  int mostRounds = 8;       ///< that are tried, ≥ 1; more than anybody adds
  bool withInstead = true;  ///< which takes as long as all the rest
};

/// `fit` is that of the measurement, `diagnosis` too, or null: then Δd as measured is taken for that of the
/// fit. Asked to stop, it returns early with less.
Outlook outlookOf(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                  const SightingProtocol& protocol, const ProtocolProgress& progress,
                  const OutlookOptions& options = {}, const std::stop_token& stop = {});

/// What the measurement will be once `rounds` further ones are there behind all of the protocol: its places
/// on the arcs as fitted so far, read without error. Absent before a pointing zero is known.
std::optional<Measurement> carriedOut(const Measurement& measurement, const SessionFit& fit,
                                      const SightingProtocol& protocol, const ProtocolProgress& progress,
                                      int rounds);

}  // namespace alidade
