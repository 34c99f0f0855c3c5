#pragma once

#include <vector>

#include "core/adjustment/joint/joint_fit.h"

namespace alidade {

/// The test by which a misread reading is called (`searchGrossErrors`): t, the shift that would explain its
/// misfit over the shift's own σ, with the scale of all other readings; Student's where the reading is sound.
struct ReadingTest {
  static constexpr double usualRisk = 0.01;
  /// Below this redundancy a reading is not tested: its shift could be anything. A visit's other readings
  /// show its error as well.
  static constexpr double leastRedundancy = 1e-4;

  double risk = usualRisk;   ///< of calling any reading of a sound session, in (0, 1)
  int tests = 1;             ///< how many different ones the session admits, ≥ 1
  int degreesOfFreedom = 0;  ///< behind the scale: those of the fit less one for each shift

  /// |t| from which a reading is called: each test has the risk 1 − (1 − α)^(1/n) (Z. Šidák, J. Am. Stat.
  /// Assoc. 62 (1967)). Infinite below one degree of freedom.
  double criticalValue() const;
  /// How large a shift, in its own σ, is called with the chance `power` in (0.5, 1): the δ at which a
  /// noncentral t exceeds the critical value c. After M. Abramowitz, I. A. Stegun, Handbook of Mathematical
  /// Functions (1964), 26.7.10: δ = c (1 − 1/(4f)) + z √(1 + c²/(2f)), z the normal quantile. At 80 % power
  /// too large by 5 % where f is 1, 2 % where it is 2, below 1 % from 4 on and 0.04 % at 27.
  double detectableShift(double power) const;
};

/// How many different tests of single readings there are: both circles of a visit of one row tell the same.
/// `readings`: visit by visit.
int differentTests(const std::vector<AdjustedReading>& readings);

}  // namespace alidade
