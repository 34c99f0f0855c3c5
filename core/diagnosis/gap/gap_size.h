#pragma once

#include <optional>

#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

// Measures of the gap of a model.

/// Rms residual of the circle readings, arcseconds.
double rmsOf(const GapModel& model);

GapSize sizeOf(const GapModel& model);

/// Excess of χ² over the degrees of freedom at the model's noise, ≥ 0.
double excessOf(const GapModel& model);

/// Δd of the model; absent without both positions.
std::optional<IntersectionEstimate> estimateOf(const GapModel& model);

}  // namespace alidade
