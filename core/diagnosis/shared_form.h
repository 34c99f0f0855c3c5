#pragma once

#include <vector>

#include "core/diagnosis/result/form.h"

namespace alidade {

/// Whether both are of one kind and order.
bool isOfOneKind(const Form& a, const Form& b);

/// Whether another session found `form`, too: a form of its kind whose shape numbers differ by at most 3 u,
/// or one with such a look-alike. A shape number without a finite u never agrees. A look-alike has the shape
/// numbers of a coarse grid, so they may differ by a fifth.
bool agrees(const FoundForm& form, const FoundForm& other);

/// The weighted mean of forms of one kind, none of them free: of each number, with u by Birge's ratio if they
/// scatter more than their u. It has the look-alikes that all of them share. Its shrinkage is not a number.
/// Source: Birge, "The Calculation of Errors by the Method of Least Squares", Phys. Rev. 40 (1932).
FoundForm meanOf(const std::vector<const FoundForm*>& forms);

}  // namespace alidade
