#pragma once

#include <Eigen/Core>

#include "core/diagnosis/gap/gap_model.h"

namespace alidade {

/// Second derivatives of the readings by the tilts of the arc plane about x and about y at the model's fit,
/// the arc angles held: columns xx, xy, yy, readings in the order of `leftover`, in σ per plausible size
/// squared. Differences of the forward model itself, over one plausible size.
Eigen::MatrixXd secondDerivativesByPlaneTilt(const GapModel& model, const Leftover& leftover);

}  // namespace alidade
