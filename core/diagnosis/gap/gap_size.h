#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

// What a model leaves over, in numbers.

/// Of the circle readings' residuals, arcseconds.
double rmsOf(const GapModel& model);

GapSize sizeOf(const GapModel& model);

/// χ² beyond the degrees of freedom, with the model's noise, ≥ 0.
double excessOf(const GapModel& model);

/// Residuals in their stated σ, in the order of `JointFit::readings`.
std::vector<double> inSigma(const GapModel& model);

/// Δd, where both positions are there.
std::optional<IntersectionEstimate> estimateOf(const GapModel& model);

}  // namespace alidade
