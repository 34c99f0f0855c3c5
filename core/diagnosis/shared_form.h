#pragma once

#include <vector>

#include "core/diagnosis/result/form.h"

namespace alidade {

/// Whether both are of one kind and order.
bool isOfOneKind(const Form& a, const Form& b);

/// Whether another session may have found `form`, too: a form of its kind whose shape numbers differ by at
/// most 3 u, or one with such a look-alike. A shape number without a finite u agrees with nothing. Of a
/// look-alike the numbers are those of a coarse grid, so that a fifth of the number is tolerated.
bool agrees(const FoundForm& form, const FoundForm& other);

/// The mean by weight of forms of one kind, none of them free: of each number, with u by Birge's ratio where
/// they scatter more than their u. It looks like what each of them looks like. Its shrinkage is not a number.
/// Source: Birge, "The Calculation of Errors by the Method of Least Squares", Phys. Rev. 40 (1932).
FoundForm meanOf(const std::vector<const FoundForm*>& forms);

}  // namespace alidade
