#pragma once

#include <Eigen/Core>

#include "core/diagnosis/gap/gap_model.h"
#include "core/effects/catalogue.h"

namespace alidade {

/// Returns the second derivatives of the readings by the two parameters of a bent effect at the model's fit,
/// with constant arc angles. Columns 11, 12, 22; readings in the order of `leftover`; σ per plausible size
/// squared. They are finite differences of the forward model over one plausible size.
Eigen::MatrixXd secondDerivatives(const GapModel& model, const Leftover& leftover, const Effect& effect);

}  // namespace alidade
