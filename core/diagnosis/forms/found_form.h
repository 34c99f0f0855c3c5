#pragma once

#include "core/diagnosis/forms/find_forms.h"
#include "core/diagnosis/forms/form_search.h"
#include "core/diagnosis/result/form.h"

namespace alidade {

/// The result for a form: formula, coefficients and parameters. The posterior probabilities of all families,
/// in `all`, give the probability of the form and the uncertainty of its order.
FoundForm foundForm(const WeighedForm& weighed, const std::vector<WeighedForm>& all);

/// Returns a formula such as "radial = A*cos(7*s) + B*sin(7*s)".
std::string formulaOf(const Form& form);

/// The look-alikes of the first of `all`: forms whose visible traces in `system` differ by less than 3 σ, or
/// that are nearly as likely.
std::vector<Form> lookAlikesOfFirst(const FormSystem& system, const FormReadings& readings,
                                    const std::vector<WeighedForm>& all);

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
