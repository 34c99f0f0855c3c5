#pragma once

#include <vector>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// Returns the entry with the fewest further measures, among equal ones that with the smallest U; null if no
/// measure reduces U.
const AttainableUncertainty* easiestMeasured(const std::vector<AttainableUncertainty>& attainable);

}  // namespace alidade
