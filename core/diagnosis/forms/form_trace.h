#pragma once

#include "core/diagnosis/forms/find_forms.h"

namespace alidade {

/// Fills `FoundForm::trace` of each form. `left` has the residuals in σ with all forms in the model.
/// `leftover` and `measurement` belong to the same model without the forms.
///
/// A sighting has several readings i with residuals rᵢ. Their derivatives by the carrier, after elimination
/// of the arc angle, are cᵢ. The sighting gives f(x) + Σ cᵢrᵢ/Σ cᵢ² as the form's value (partial residual).
/// Source: Larsen and McCleary, "The use of partial residual plots", Technometrics 14 (1972).
void addTraces(FoundForms& found, const Eigen::VectorXd& left, const Leftover& leftover,
               const Measurement& measurement, const FormReadings& readings);

/// Fills `FoundForm::cleanRange`.
void addCleanRange(FoundForm& found, const FormReadings& readings);

}  // namespace alidade
