#pragma once

#include <vector>

#include "core/adjustment/joint/joint_fit.h"

namespace alidade {

/// The test that names a misread reading (`searchGrossErrors`): t is the shift that explains the misfit,
/// divided by its σ, scaled by the scatter of all others. For a sound reading t has Student's distribution.
struct ReadingTest {
  static constexpr double usualRisk = 0.01;
  /// Below this redundancy a reading is not tested: its shift is undetermined. Its error also shows in the
  /// other readings of its visit.
  static constexpr double leastRedundancy = 1e-4;

  double risk = usualRisk;   ///< of naming any reading of a sound session, in (0, 1)
  int tests = 1;             ///< number of different tests in the session, ≥ 1
  int degreesOfFreedom = 0;  ///< of the scale: those of the fit minus one for each shift

  /// |t| from which a reading is named: each test has the risk 1 − (1 − α)^(1/n) (Z. Šidák, J. Am. Stat.
  /// Assoc. 62 (1967)). Infinite below one degree of freedom.
  double criticalValue() const;
  /// The shift, in its own σ, that is named with probability `power` in (0.5, 1): the δ at which a noncentral
  /// t exceeds the critical value c. After M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions
  /// (1964), 26.7.10: δ = c (1 − 1/(4f)) + z √(1 + c²/(2f)), z the normal quantile. At 80 % power the result
  /// is too large by 5 % if f is 1, 2 % if it is 2, below 1 % from 4 on and 0.04 % at 27.
  double detectableShift(double power) const;
};

/// The number of different tests of single readings. In a visit of one row without a slider reading, both
/// circles give the same test. `readings`: visit by visit.
int differentTests(const std::vector<AdjustedReading>& readings);

}  // namespace alidade
