#pragma once

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

}  // namespace alidade
