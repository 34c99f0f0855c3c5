#pragma once

#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/search/explanation.h"

namespace alidade {

/// `base` with the parts of an explanation added, fitted anew.
GapModel modelWith(const GapModel& base, const Explanation& explanation, const Candidates& candidates,
                   const Leftover& leftover);

}  // namespace alidade
