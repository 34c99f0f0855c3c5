#pragma once

#include <Eigen/Core>

#include "core/diagnosis/gap/gap_model.h"
#include "core/effects/catalogue.h"

namespace alidade {

/// Second derivatives of the readings by the two numbers of an effect that bends at the model's fit, the arc
/// angles held: columns 11, 12, 22, readings in the order of `leftover`, in σ per plausible size squared.
/// Differences of the forward model itself, over one plausible size.
Eigen::MatrixXd secondDerivatives(const GapModel& model, const Leftover& leftover, const Effect& effect);

}  // namespace alidade
