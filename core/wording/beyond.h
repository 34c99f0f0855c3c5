#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// Returns "averaged over the indistinguishable causes", …; empty for `Nothing`.
std::string textOf(Beyond beyond);

}  // namespace alidade
