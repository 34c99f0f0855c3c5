#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"
#include "core/session/measurement.h"

namespace alidade {

/// How well rows of one visit go with each other and with all other readings.
struct VisitAgreement {
  int tests = 0;  ///< how many conditions the visit has to meet: readings − 1
  /// That sound readings misfit by as much or more; 0 where the fit predicts too poorly to tell.
  double probability = 0;
  /// How far the place is off the even spacing, in its scatter; 0 where nothing is known of the spacing.
  double offSpacing = 0;
  double logLikelihood = 0;  ///< of the misfit, by Student's distribution, and of the place, up to a constant
  std::vector<double> residuals;  ///< rad, as reduced: horizontal and vertical of each row, then the slider
};

/// The situation: rows of one visit are in question, so every other reading is fitted, and rows as they may
/// have been meant are held against that fit. The target may stand anywhere on the arc, but where the other
/// places are evenly spaced by their point numbers, a place that keeps the spacing is likelier: their own
/// scatter about even spacing says by how much, and one place off the spacing is never ruled out (Student's
/// distribution with 3 degrees of freedom).
class VisitCheck {
 public:
  /// Checks visits of arc `arc` against `fit`, in which the sightings `inQuestion` have no part; they tell
  /// nothing of the spacing either. `options` are those of the fit.
  VisitCheck(const Measurement& measurement, std::size_t arc, const std::vector<ReadingRef>& inQuestion,
             const JointFit& fit, const JointFitOptions& options);
  ~VisitCheck();
  VisitCheck(VisitCheck&&) noexcept;
  VisitCheck& operator=(VisitCheck&&) noexcept;

  /// There are enough other readings to check by.
  bool canCheck() const;

  /// `rows`: of one visit, each face at most once.
  VisitAgreement agreement(const std::vector<Sighting>& rows) const;

 private:
  struct Content;
  std::unique_ptr<Content> m_content;
};

/// All readings of a visit of the arc, and the same of several.
std::vector<ReadingRef> readingsOf(const Measurement& measurement, std::size_t arc, int round, int point);

}  // namespace alidade
