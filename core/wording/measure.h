#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// "both faces", "the way back", …
std::string textOf(Measure measure);
/// "both faces and the way back".
std::string textOf(const std::vector<Measure>& measures);
/// "both faces (read anew)", where the session has to be, else "… (in addition)".
std::string howTo(const std::vector<Measure>& measures);

}  // namespace alidade
