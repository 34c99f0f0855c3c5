#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// "averaged over what looks alike", …; empty for nothing.
std::string textOf(Beyond beyond);

}  // namespace alidade
