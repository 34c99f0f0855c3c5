#pragma once

#include <vector>

#include "core/diagnosis/conclusion/answer.h"

namespace alidade {

// What is known beforehand, held against the readings. A number known as N(v, u²) that a fit has at x with
// the variance Q holds the share g = Q/u² of what was known; the readings alone say (x − g v)/(1 − g), with
// the variance Q/(1 − g).

/// Of each number that is known and in the answer's model.
std::vector<KnownCheck> knownChecks(const Inquiry& inquiry, const Answer& answer);

}  // namespace alidade
