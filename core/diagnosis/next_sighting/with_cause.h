#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/next_sighting/sighting_equations.h"
#include "core/diagnosis/next_sighting/weighed.h"

namespace alidade {

/// The equations if `cause` is present for certain: its size is one more unknown, and the hypotheses are the
/// further causes beside it. `group` has the causes that no sighting separates from it: they are none.
/// Another gross error is one.
SightingEquations withCause(const SightingEquations& equations, const Weighed& cause,
                            const std::vector<std::string>& group);

}  // namespace alidade
