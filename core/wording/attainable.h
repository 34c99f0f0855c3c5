#pragma once

#include <vector>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// Returns the entry with the fewest measures, and of several such entries the one with the smallest U. Null
/// if no entry has measures.
const AttainableUncertainty* easiestMeasured(const std::vector<AttainableUncertainty>& attainable);

}  // namespace alidade
