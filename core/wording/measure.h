#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// "both faces", "a return run", …
std::string textOf(Measure measure);
/// "both faces and a return run".
std::string textOf(const std::vector<Measure>& measures);
/// "both faces (in a new session)" if the measures require a new session, otherwise "… (in addition)".
std::string howTo(const std::vector<Measure>& measures);

/// Returns the entry with the fewest measures, and of several such entries the one with the smallest U. Null
/// if no entry has measures.
const AttainableUncertainty* easiestMeasured(const std::vector<AttainableUncertainty>& attainable);

}  // namespace alidade
