#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/diagnosis.h"
#include "core/diagnosis/gap_model.h"

namespace alidade {

// What a model leaves over, in numbers. For the .cpp files of this room only.

GapSize sizeOf(const GapModel& model);

/// χ² beyond the degrees of freedom, with the model's noise, ≥ 0.
double excessOf(const GapModel& model);

/// Residuals/σ in the order of `JointFit::readings`.
std::vector<double> inSigma(const GapModel& model);

/// Δd, where both positions are there.
std::optional<IntersectionEstimate> estimateOf(const GapModel& model);

}  // namespace alidade
