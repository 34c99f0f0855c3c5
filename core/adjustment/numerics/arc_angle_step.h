#pragma once

#include <algorithm>

namespace alidade {

// Gauss-Newton for the arc angle of a point replaces the arc by its tangent: a point at distance d from the
// centre, θ away along the arc, moves by d/R sin θ. If d is many R, or the arc runs along the line of sight,
// this is several turns. A bounded step keeps its sign. So from any start the point takes the short way to
// its foot, and stays on its side of the circle.

/// rad: up to there the tangent deviates from the arc by at most 4.5 % of R, so a shorter step is reliable.
/// Half the circle takes eleven of them.
inline constexpr double longestArcAngleStep = 0.3;

/// `step` of an arc angle, rad, limited to the reliable length.
constexpr double boundedArcAngleStep(double step) {
  return std::clamp(step, -longestArcAngleStep, longestArcAngleStep);
}

}  // namespace alidade
