#pragma once

#include <optional>
#include <vector>

#include "core/adjustment/result/intersection.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/session/measurement.h"

namespace alidade {

// U of Δd, mm, for a planned measurement. `plan` holds error-free readings of the planned visits, `noise` is
// the ratio of expected to stated scatter. Results are absent or empty without both positions, or if the plan
// does not determine Δd.

/// U from the fit only. If the scatter is estimated, it has the degrees of freedom of the plan.
std::optional<double> plannedUncertaintyOfFit(const Measurement& plan, const NoiseScale& noise);

/// U of the measured Δd: only the first value of `plannedUncertainties`, computed much faster.
std::optional<double> plannedUncertainty(const Measurement& plan, double noise);

/// U of the measured Δd, also with more readings or known effects: `attainableUncertainties`.
std::vector<AttainableUncertainty> plannedUncertainties(const Measurement& plan, double noise);

}  // namespace alidade
