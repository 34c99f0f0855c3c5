#include "core/adjustment/joint/reliability.h"

#include <cmath>

namespace alidade {

Detection detectionIn(const JointFit& fit, double scale, double power) {
  Detection detection{
      .test = {.tests = differentTests(fit.readings), .degreesOfFreedom = fit.degreesOfFreedom - 1},
      .power = power,
      .scale = scale};
  detection.shift = detection.test.detectableShift(power);
  return detection;
}

Reliability reliabilityOf(const AdjustedReading& reading, const Detection& detection) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double bias = reading.isChecked()
                          ? detection.shift * detection.scale * reading.sigma / std::sqrt(reading.redundancy)
                          : infinite;
  return {Angle::fromRadians(bias), reading.perReading == 0 ? 0 : bias * reading.perReading};
}

}  // namespace alidade
