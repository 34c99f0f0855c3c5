#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/diagnosis/component.h"
#include "core/diagnosis/visibility.h"

namespace alidade {

// Which effects leave the same trace in these very readings. For the .cpp files of this room only.

/// How far the nearest trace that the component can leave is from `trace` (a visible part), in σ of the
/// readings: two effects this far apart are taken for one another in Φ(−d/2) of the cases.
double differenceFrom(const Eigen::VectorXd& trace, const Component& component);

/// How like the component's nearest trace is.
LookAlike compared(const Eigen::VectorXd& trace, const Component& component);

/// Mistaken for one another in 7 % of the cases: no answer to rely on.
inline constexpr double hardlyDifferent = 3.0;
/// Mistaken in 2 %: told apart, where the readings agree.
inline constexpr double clearlyDifferent = 4.2;

}  // namespace alidade
