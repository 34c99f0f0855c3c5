#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

/// "Sessions like this one come to U = 0.23 mm; with slider readings to 0.20 mm, …; with trunnion_tilt known
/// to 0.21 mm.": of what brings U down the cheapest, and what does so the most. Empty where nothing is known
/// of it; effects are called as `name` has it.
std::string attainableSentence(const std::vector<AttainableUncertainty>& attainable,
                               const CauseNamer& name = byId);

/// What takes the fewest further measures, of as many what brings U down the most; null where nothing does.
const AttainableUncertainty* easiestMeasured(const std::vector<AttainableUncertainty>& attainable);

}  // namespace alidade
