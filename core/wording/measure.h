#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// "both faces", "the way back", …
std::string textOf(Measure measure);

}  // namespace alidade
