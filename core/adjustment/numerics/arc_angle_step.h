#pragma once

#include <algorithm>

namespace alidade {

// A Gauss-Newton step of an arc angle replaces the arc by its tangent. If the sighted point is at distance d
// from the centre and θ away along the arc, the step is d/R sin θ. If d is many R, or the arc runs along the
// line of sight, this is several turns. A bounded step keeps its sign: from any start the point takes the
// short way to its foot, and stays on its side of the circle.

/// rad. Over this angle the tangent deviates from the arc by at most 4.5 % of R, so the step is reliable.
/// Half the circle takes eleven such steps.
inline constexpr double longestArcAngleStep = 0.3;

/// `step` of an arc angle, rad, limited to the reliable length.
constexpr double boundedArcAngleStep(double step) {
  return std::clamp(step, -longestArcAngleStep, longestArcAngleStep);
}

}  // namespace alidade
