#pragma once

#include <vector>

#include "core/diagnosis/result/form.h"

namespace alidade {

/// Whether both are of one kind and order.
bool isOfOneKind(const Form& a, const Form& b);

/// Whether `other`, of another session, shows the same form: kind and order are equal, and shape numbers
/// differ by at most 3 u. A look-alike of `other` also counts. Shape numbers of look-alikes come from a
/// coarse grid: they may differ by a fifth. False if a shape number of `form` has no finite u.
bool agrees(const FoundForm& form, const FoundForm& other);

/// Returns the weighted mean of each number of forms of one kind and order, none of them free. u includes
/// Birge's ratio for larger scatter. The result has the look-alikes common to all; its shrinkage is NaN.
/// Source: Birge, "The Calculation of Errors by the Method of Least Squares", Phys. Rev. 40 (1932).
FoundForm meanOf(const std::vector<const FoundForm*>& forms);

}  // namespace alidade
