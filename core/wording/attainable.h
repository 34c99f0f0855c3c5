#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

/// Returns "Sessions like this one come to U = 0.23 mm; with slider readings to 0.20 mm, …; with
/// trunnion_tilt known to 0.21 mm." It names the easiest measures and the most effective one. Empty if the
/// list is empty; `name` names the effects.
std::string attainableSentence(const std::vector<AttainableUncertainty>& attainable);

/// Returns the entry with the fewest further measures, among equal ones that with the smallest U; null if no
/// measure reduces U.
const AttainableUncertainty* easiestMeasured(const std::vector<AttainableUncertainty>& attainable);

}  // namespace alidade
