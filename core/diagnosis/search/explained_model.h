#pragma once

#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/search/explanation.h"

namespace alidade {

/// Returns `base` with the parts of an explanation added, fitted again.
GapModel modelWith(const GapModel& base, const Explanation& explanation, const Candidates& candidates,
                   const Leftover& leftover);

}  // namespace alidade
