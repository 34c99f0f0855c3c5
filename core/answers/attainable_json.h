#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// `[{"measure": "", "known": "", "expanded_mm": 0.23}, {"measure": "slider readings", …}, …]`
nlohmann::ordered_json attainableJson(const std::vector<AttainableUncertainty>& attainable);

}  // namespace alidade
