#include "core/adjustment/reliability.h"

#include <cmath>
#include <limits>

#include "core/base/statistics.h"

namespace alidade {

Reliability reliabilityOf(const AdjustedReading& reading, const DetectionLevel& level) {
  constexpr double unchecked = 1e-9;  // rounding of a redundancy of 0
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (reading.redundancy < unchecked)
    return {Angle::fromRadians(infinite),
            reading.perReading == 0 ? 0 : std::copysign(infinite, reading.perReading)};
  // The shift of a normal variable that exceeds the two-sided bound with the stated chance.
  const double shift =
      coverageFactor(1 - level.risk, infinite) + coverageFactor(2 * level.power - 1, infinite);
  const double bias = shift * reading.sigma / std::sqrt(reading.redundancy);
  return {Angle::fromRadians(bias), bias * reading.perReading};
}

}  // namespace alidade
