#pragma once

#include "core/diagnosis/forms/find_forms.h"

namespace alidade {

/// Fills `FoundForm::trace` of each form. `left`: of the readings, in their σ, with all forms in the model,
/// whose leftover and measurement are `leftover` and `measurement`.
///
/// A sighting has several readings. With cᵢ what one unit of the carrier does to each of them, outside the
/// arc angle, and rᵢ what is left, the sighting says f(x) + Σ cᵢrᵢ/Σ cᵢ² of the form (a partial residual).
/// Source: Larsen and McCleary, "The use of partial residual plots", Technometrics 14 (1972).
void addTraces(FoundForms& found, const Eigen::VectorXd& left, const Leftover& leftover,
               const Measurement& measurement, const FormReadings& readings);

/// Fills `FoundForm::cleanRange`.
void addCleanRange(FoundForm& found, const FormReadings& readings);

}  // namespace alidade
