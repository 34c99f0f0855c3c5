#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/next_sighting/sighting_equations.h"
#include "core/diagnosis/next_sighting/weighed.h"

namespace alidade {

/// The equations with `cause` present for certain. Its size is one more unknown; the prior is centred at the
/// estimate and as wide as the estimate is large. The hypotheses are further causes, without `group`, the
/// causes that no sighting separates from `cause`. A jump or wrong zero excludes all others; a further gross
/// error stays.
SightingEquations withCause(const SightingEquations& equations, const Weighed& cause,
                            const std::vector<std::string>& group);

}  // namespace alidade
