#pragma once

#include "core/diagnosis/forms/find_forms.h"

namespace alidade {

/// Fills `FoundForm::trace` of each form. `left` has the residuals in σ with all forms in the model.
/// `leftover` and `measurement` are those of the same model without the forms.
///
/// A sighting has several readings. With cᵢ the change of reading i by one unit of the carrier, arc angle
/// eliminated, and rᵢ its residual, the sighting gives f(x) + Σ cᵢrᵢ/Σ cᵢ² as the form's value (a partial
/// residual). Source: Larsen and McCleary, "The use of partial residual plots", Technometrics 14 (1972).
void addTraces(FoundForms& found, const Eigen::VectorXd& left, const Leftover& leftover,
               const Measurement& measurement, const FormReadings& readings);

/// Fills `FoundForm::cleanRange`.
void addCleanRange(FoundForm& found, const FormReadings& readings);

}  // namespace alidade
