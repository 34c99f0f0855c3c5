#pragma once

#include <vector>

#include "core/diagnosis/conclusion/answer.h"

namespace alidade {

// Comparison of known sizes with the readings. If a number is known as N(v, u²) and a fit gives x with
// variance Q, the fit contains the known value with the share g = Q/u². The readings alone give
// (x − g v)/(1 − g), with variance Q/(1 − g).

/// The check of each known number in the answer's model.
std::vector<KnownCheck> knownChecks(const Inquiry& inquiry, const Answer& answer);

}  // namespace alidade
