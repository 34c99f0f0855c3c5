#include "tests/bench/speed/readings.h"

#include <cmath>
#include <numbers>

#include "core/base/angle.h"
#include "core/base/random_source.h"
#include "core/observation/perfect_theodolite.h"

namespace alidade::bench {

ArcSetup usualSetup() {
  const double sigma = Angle::fromArcseconds(2).radians();
  return {.distance = 2405, .sigmaHorizontal = sigma, .sigmaVertical = sigma};
}

std::span<const double> ArcReadings::horizontal(std::size_t first, std::size_t count) const {
  return std::span(a).subspan(first, count);
}

std::span<const double> ArcReadings::vertical(std::size_t first, std::size_t count) const {
  return std::span(e).subspan(first, count);
}

ArcReadings noisyArcs(std::size_t arcs, std::size_t points) {
  const ArcSetup setup = usualSetup();
  const double degree = std::numbers::pi / 180;
  RandomSource random(1, points);
  ArcReadings readings;
  readings.a.reserve(arcs * points);
  readings.e.reserve(arcs * points);
  for (std::size_t arc = 0; arc < arcs; ++arc) {
    const Circle circle{1 + random.uniform(-1, 1), -0.5 + random.uniform(-1, 1), 400 + random.uniform(-1, 1)};
    for (std::size_t i = 0; i < points; ++i) {
      const double phi = (30 + 120 * static_cast<double>(i) / static_cast<double>(points - 1)) * degree;
      const Direction<double> seen = observe(targetOnArc(circle.x, circle.y, circle.radius, phi),
                                             setup.distance, VerticalAngleRelation::Exact);
      readings.a.push_back(seen.a + setup.sigmaHorizontal * random.normal());
      readings.e.push_back(seen.e + setup.sigmaVertical * random.normal());
    }
  }
  return readings;
}

const ArcReadings& shortArcs() {
  static const ArcReadings readings = noisyArcs(manyArcs, pointsOfArc);
  return readings;
}

const ArcReadings& longArc() {
  static const ArcReadings readings = noisyArcs(1, manyPoints);
  return readings;
}

}  // namespace alidade::bench
