#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/adjustment/gross_errors/corrections.h"
#include "core/adjustment/gross_errors/gross_error_search.h"
#include "core/adjustment/gross_errors/visit_check.h"
#include "core/adjustment/joint/joint_fit.h"
#include "core/base/angle.h"
#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade {

/// A visit in question, with its rows as typed.
struct Visited {
  std::size_t arc = 0;  ///< index into the measurement's arcs
  int round = 1, point = 0;
  std::vector<std::size_t> rows;  ///< indices into the readings of the position

  /// The visit with one more row.
  Visited with(std::size_t row) const;
};

/// A correction that makes its visit agree with all others.
struct AgreeingCorrection {
  Correction correction;
  Sighting sighting;      ///< of the row in question, corrected
  double score = 0;       ///< logarithm of prior times likelihood, up to a constant
  Angle residual;         ///< of the first changed cell, as read
  double offSpacing = 0;  ///< as `VisitAgreement::offSpacing`
};

/// Returns the kind of reading that a cell holds. A changed face turns both circles and counts as a
/// horizontal reading.
ReadingKind kindOf(const std::string& field);

/// Misread readings of a session, and corrections of the typed text that would explain them: each is tested
/// against a fit of all other readings.
class CorrectionTrials {
 public:
  /// Searches `fitted`, the fitted part of the measurement of `session`, at the stated risk of naming a sound
  /// reading. `fit`: of all its readings. After a stop request the search finds nothing.
  CorrectionTrials(const Session& session, Measurement fitted, const JointFit& fit, double risk,
                   const std::stop_token& stop);

  const Measurement& measurement() const { return m_fitted; }
  const std::vector<GrossError>& grossErrors() const { return m_search.grossErrors; }
  std::vector<GrossError> grossErrorsIn(const Visited& visit) const;
  const Sighting& sightingOf(const ReadingRef& cell) const {
    return m_fitted.arcs[cell.arc].sightings[cell.sighting];
  }
  Visited visitOf(std::size_t arc, int round, int point) const;

  /// Checks against a fit without the visits in question.
  VisitCheck checkOf(const Visited& visit, const Visited* other = nullptr) const;
  bool agreesAsTyped(const Visited& visit, const VisitCheck& check);
  /// The corrections that make the visit agree, the most probable first. `keptOff`: misread cells of the
  /// visit whose error is subtracted, not corrected. With `only`, corrections of that cell alone.
  std::vector<AgreeingCorrection> agreeing(const Visited& visit, const VisitCheck& check,
                                           const std::vector<GrossError>& keptOff = {},
                                           const ReadingRef* only = nullptr);

 private:
  std::vector<Sighting> rowsWith(const Visited& visit, const Correction& correction,
                                 const std::vector<GrossError>& keptOff);
  std::optional<double> gainElsewhere(const Visited& visit, const Correction& correction);
  double sliderDisagreement(const std::vector<Sighting>& rows) const;
  std::optional<AgreeingCorrection> tryOut(const Visited& visit, const VisitCheck& check,
                                           const Correction& correction,
                                           const std::vector<GrossError>& keptOff);

  const Session& m_session;
  Measurement m_fitted;
  RowReader m_reader;
  JointFitOptions m_fitOptions;
  GrossErrorSearch m_search;
  Measurement m_sound;  ///< with the shifts of all misread readings subtracted
  std::vector<Circle> m_starts;
};

}  // namespace alidade
