#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// Returns "averaged over what looks alike", …; empty for `Nothing`.
std::string textOf(Beyond beyond);

}  // namespace alidade
