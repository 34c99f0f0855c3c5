#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/observation/guideway.h"
#include "core/session/measurement.h"

namespace alidade::test {

/// `count` arc angles spaced evenly over `spanDegrees` around `middleDegrees`, in radians.
inline std::vector<double> spread(int count, double spanDegrees, double middleDegrees = 90) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) {
    const double share = count == 1 ? 0.5 : static_cast<double>(i) / (count - 1);
    angles.push_back((middleDegrees + (share - 0.5) * spanDegrees) * std::numbers::pi / 180);
  }
  return angles;
}

/// A measurement without arcs: L 2405 mm, R0 400 mm, 2″ on both circles, zeros and distance exact.
inline Measurement usualMeasurement() {
  Measurement measurement;
  measurement.distance = 2405;
  measurement.nominalRadius = 400;
  measurement.sigmaHorizontal = measurement.sigmaVertical = Angle::fromArcseconds(2);
  measurement.sigmaSlider = Angle::fromArcseconds(5);
  return measurement;
}

/// The readings of targets on `circle` in closed form, independent of the program's model. The direction to
/// the target is from tan a = x/L and sin e = y/|P| (exact) or tan e = y/L (planar).
inline ArcMeasurement perfectArc(const Measurement& measurement, const Circle& circle,
                                 const std::vector<double>& angles, int axisDeg = 0) {
  ArcMeasurement arc;
  arc.axisDeg = axisDeg;
  arc.position = axisDeg == 0 ? 0 : 1;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double x = circle.x + circle.radius * std::cos(angles[i]),
                 y = circle.y + circle.radius * std::sin(angles[i]);
    const double l = measurement.distance;
    Sighting sighting;
    sighting.row = i;
    sighting.point = static_cast<int>(i) + 1;
    sighting.a = Angle::fromRadians(std::atan(x / l));
    sighting.e = Angle::fromRadians(measurement.relation == VerticalAngleRelation::Exact
                                        ? std::asin(y / std::sqrt(x * x + y * y + l * l))
                                        : std::atan(y / l));
    arc.sightings.push_back(sighting);
  }
  return arc;
}

/// Adds independent normal noise of the stated σ to every reading.
template <typename Generator>
void addNoise(ArcMeasurement& arc, const Measurement& measurement, Generator& generator) {
  std::normal_distribution<double> normal;
  for (Sighting& sighting : arc.sightings) {
    sighting.a = sighting.a + measurement.sigmaHorizontal * normal(generator);
    sighting.e = sighting.e + measurement.sigmaVertical * normal(generator);
  }
}

}  // namespace alidade::test
