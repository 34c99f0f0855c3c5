#pragma once

#include <algorithm>

namespace alidade {

// Gauss-Newton for the arc angle of a point takes the arc for its tangent: a point at distance d from the
// centre, θ away along the arc, is sent d/R sin θ on. Of a start far off d is many R, or the arc runs along
// the line of sight, and then that is turns. Bounded, the step keeps its sign, and so the point, wherever it
// starts, goes the short way to its foot and stays on its side of the circle.

/// rad: the tangent leaves the arc by 4.5 % of R up to there, so a shorter step is to be believed. Half the
/// circle takes eleven of them.
inline constexpr double longestArcAngleStep = 0.3;

/// `step` of an arc angle, rad, as far as it is to be believed.
constexpr double boundedArcAngleStep(double step) {
  return std::clamp(step, -longestArcAngleStep, longestArcAngleStep);
}

}  // namespace alidade
