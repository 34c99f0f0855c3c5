#pragma once

#include <optional>
#include <vector>

#include "core/adjustment/result/intersection.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/session/measurement.h"

namespace alidade {

// U of Δd, mm, that a measurement will have which is only planned: its readings without error, at the places
// where they will be taken. `noise`: what they are expected to scatter by over what is stated. All absent or
// empty without both positions, or where the plan does not determine Δd.

/// Of the fit alone. Where the scatter was estimated, so it will be, with the degrees of freedom of the plan.
std::optional<double> plannedUncertaintyOfFit(const Measurement& plan, const NoiseScale& noise);

/// As measured: the first of `plannedUncertainties` alone, in a fraction of the time.
std::optional<double> plannedUncertainty(const Measurement& plan, double noise);

/// As measured, and with more read or known: `attainableUncertainties`.
std::vector<AttainableUncertainty> plannedUncertainties(const Measurement& plan, double noise);

}  // namespace alidade
