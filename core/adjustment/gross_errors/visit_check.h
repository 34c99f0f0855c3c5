#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"
#include "core/session/measurement.h"

namespace alidade {

/// The agreement of the rows of one visit with each other and with all other readings.
struct VisitAgreement {
  int tests = 0;  ///< number of conditions on the visit: readings − 1
  /// Probability that sound readings misfit as much or more; 0 if the fit predicts too poorly to decide.
  double probability = 0;
  /// Deviation of the place from the even spacing, in units of its scatter; 0 if the spacing is unknown.
  double offSpacing = 0;
  double logLikelihood = 0;  ///< of the misfit, by Student's distribution, and of the place, up to a constant
  std::vector<double> residuals;  ///< rad, reduced: horizontal and vertical of each row, then the slider
};

/// The situation: rows of one visit are in question. Every other reading is fitted, and possible intended
/// rows are compared with that fit. The target may be anywhere on the arc. But if the other places are evenly
/// spaced by their point numbers, a place that keeps the spacing is more probable; the scatter about even
/// spacing determines by how much. A single place off the spacing is never excluded (Student's distribution
/// with 3 degrees of freedom).
class VisitCheck {
 public:
  /// Checks visits of arc `arc` against `fit`, which has these `options`. Both the fit and the spacing
  /// exclude the sightings `inQuestion`.
  VisitCheck(const Measurement& measurement, std::size_t arc, const std::vector<ReadingRef>& inQuestion,
             const JointFit& fit, const JointFitOptions& options);
  ~VisitCheck();
  VisitCheck(VisitCheck&&) noexcept;
  VisitCheck& operator=(VisitCheck&&) noexcept;

  /// Are there enough other readings for a check?
  bool canCheck() const;

  /// `rows`: of one visit, each face at most once.
  VisitAgreement agreement(const std::vector<Sighting>& rows) const;

 private:
  struct Content;
  std::unique_ptr<Content> m_content;
};

/// All readings of one visit of the arc.
std::vector<ReadingRef> readingsOf(const Measurement& measurement, std::size_t arc, int round, int point);

}  // namespace alidade
