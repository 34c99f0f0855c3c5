#pragma once

#include "core/diagnosis/forms/form_search.h"
#include "core/diagnosis/result/form.h"

namespace alidade {

/// The result of a form: formula, coefficients and parameters. `all`: the posterior of every family, for the
/// uncertainty of an order.
FoundForm foundForm(const WeighedForm& weighed, const std::vector<WeighedForm>& all);

/// "radial = A*cos(7*s) + B*sin(7*s)".
std::string formulaOf(const Form& form);

/// The others that these readings cannot tell from the first of `all`, whose traces are visible in `system`:
/// they differ by less than 3 σ, or are nearly as likely.
std::vector<Form> lookAlikesOfFirst(const FormSystem& system, const FormReadings& readings,
                                    const std::vector<WeighedForm>& all);

}  // namespace alidade
