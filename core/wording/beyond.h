#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// Names what U includes beyond the fit: "averaged over the indistinguishable causes"; empty for `Nothing`.
std::string textOf(Beyond beyond);

}  // namespace alidade
