#include "core/adjustment/joint/reliability.h"

#include <cmath>
#include <limits>

#include "core/base/statistics.h"

namespace alidade {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The shift of a normal variable that exceeds the two-sided bound with the stated chance.
double detectableShift(const DetectionLevel& level) {
  return coverageFactor(1 - level.risk, infinite) + coverageFactor(2 * level.power - 1, infinite);
}

}  // namespace

Reliability reliabilityOf(const AdjustedReading& reading, const DetectionLevel& level) {
  constexpr double unchecked = 1e-9;  // rounding of a redundancy of 0
  if (reading.redundancy < unchecked)
    return {Angle::fromRadians(infinite),
            reading.perReading == 0 ? 0 : std::copysign(infinite, reading.perReading)};
  static const double usualShift = detectableShift({});  // quantiles take longer than all the rest
  const double shift = level == DetectionLevel{} ? usualShift : detectableShift(level);
  const double bias = shift * reading.sigma / std::sqrt(reading.redundancy);
  return {Angle::fromRadians(bias), bias * reading.perReading};
}

}  // namespace alidade
