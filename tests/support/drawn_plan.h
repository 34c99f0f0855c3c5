#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/simulation/truth.h"

namespace alidade::test {

// Plans of readings and set-ups of any geometry, drawn from a seed. The common properties of all named plans
// (9 or 17 points, half a circle, 400 mm at 2.4 m, 2″) are varied here.

/// A number in a range, uniform in its logarithm.
inline double drawnSize(std::mt19937_64& random, double least, double most) {
  return std::exp(std::uniform_real_distribution<double>(std::log(least), std::log(most))(random));
}

inline int drawnCount(std::mt19937_64& random, int least, int most) {
  return std::uniform_int_distribution<int>(least, most)(random);
}

inline bool drawnChance(std::mt19937_64& random, double probability) {
  return std::bernoulli_distribution(probability)(random);
}

struct DrawnPlan {
  Protocol protocol;
  Truth truth;
};

/// 3 to `mostPoints` places over 20° to 350° of arc, one to three rounds, one face, both or alternating
/// faces, with or without slider, occasionally a repeated axis; L from 0.5 to 50 m, R from 50 mm to 5 m but
/// within 45° of the line of sight, both σ from 0.1″ to 60″. Without any effect.
inline DrawnPlan drawnPlan(std::mt19937_64& random, int mostPoints, std::uint64_t seed) {
  DrawnPlan plan;
  Protocol& protocol = plan.protocol;
  protocol.name = "drawn";
  protocol.points = static_cast<int>(std::lround(drawnSize(random, 3, mostPoints)));
  const double span = std::uniform_real_distribution<double>(20, 350)(random);
  protocol.step = Angle::fromDegrees(span / protocol.points);
  protocol.first = Angle::fromDegrees(std::uniform_real_distribution<double>(0, 355 - span)(random));
  protocol.rounds = drawnCount(random, 1, 3);
  protocol.faces = static_cast<FacePlan>(drawnCount(random, 0, 2));
  protocol.slider = drawnChance(random, 0.5);
  while (drawnChance(random, 0.1)) protocol.axes.push_back(drawnChance(random, 0.5) ? 0 : 180);

  Truth& truth = plan.truth;
  truth = drawTruth(seed);
  truth.distance = drawnSize(random, 500, 50000);
  truth.radius = std::min(drawnSize(random, 50, 5000), 0.9 * truth.distance);
  truth.nominalRadius = truth.radius * std::uniform_real_distribution<double>(0.98, 1.02)(random);
  truth.sigmaDistance = drawnChance(random, 0.5) ? 0 : drawnSize(random, 0.01, 5);
  truth.sigmaHorizontal = Angle::fromArcseconds(drawnSize(random, 0.1, 60));
  truth.sigmaVertical = Angle::fromArcseconds(drawnSize(random, 0.1, 60));
  truth.sigmaZero = Angle::fromArcseconds(drawnSize(random, 0.1, 60));
  truth.sigmaSlider = Angle::fromArcseconds(drawnSize(random, 1, 60));
  const Angle finest = std::min(truth.sigmaHorizontal, truth.sigmaVertical);
  truth.typingStep = Angle::fromArcseconds(finest.arcseconds() < 1 ? 0.01 : 0.1);
  if (drawnChance(random, 0.2)) {
    truth.verticalCircle = VerticalCircle::Elevation;
    truth.verticalZero = Angle();
  }
  return plan;
}

}  // namespace alidade::test
