#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/next_sighting/sighting_equations.h"
#include "core/diagnosis/next_sighting/weighed.h"

namespace alidade {

/// The equations if `cause` is present for certain: its size is one more unknown, with a prior about its
/// estimate as wide as that is large, and the hypotheses are further causes. `group` has the causes that no
/// sighting separates from it: they are left out. If the cause is a jump or a wrong zero, the other ones are
/// left out, too. Another gross error stays.
SightingEquations withCause(const SightingEquations& equations, const Weighed& cause,
                            const std::vector<std::string>& group);

}  // namespace alidade
