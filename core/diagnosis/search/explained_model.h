#pragma once

#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/search/explanation.h"

namespace alidade {

/// Returns `base` plus the parts of an explanation and the prior of a pause (`addPause`), after a new fit.
GapModel modelWith(const GapModel& base, const Explanation& explanation, const Candidates& candidates,
                   const Leftover& leftover);

}  // namespace alidade
