#include "core/adjustment/joint/reading_test.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/statistics.h"

namespace alidade {

double ReadingTest::criticalValue() const {
  if (degreesOfFreedom < 1) return std::numeric_limits<double>::infinity();
  const double outside = -std::expm1(std::log1p(-risk) / tests);
  return coverageFactor(1 - outside, degreesOfFreedom);
}

double ReadingTest::detectableShift(double power) const {
  const double critical = criticalValue();
  if (!std::isfinite(critical)) return critical;
  const double normal = coverageFactor(2 * power - 1, DegreesOfFreedom::infinite());
  return critical * (1 - 1 / (4.0 * degreesOfFreedom)) +
         normal * std::sqrt(1 + critical * critical / (2.0 * degreesOfFreedom));
}

int differentTests(const std::vector<AdjustedReading>& readings) {
  int count = 0;
  for (std::size_t i = 0; i < readings.size();) {
    const std::size_t first = i;
    int takingPart = 0, testable = 0;
    for (; i < readings.size() && readings[i].arc == readings[first].arc &&
           readings[i].visit == readings[first].visit;
         ++i) {
      if (readings[i].redundancy != 0) ++takingPart;
      if (readings[i].redundancy > ReadingTest::leastRedundancy) ++testable;
    }
    count += takingPart == 2 ? std::min(testable, 1) : testable;
  }
  return std::max(count, 1);
}

}  // namespace alidade
