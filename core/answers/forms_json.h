#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/diagnosis/result/form.h"

namespace alidade {

/// Returns the array `forms` of a result.
nlohmann::ordered_json formsJson(const std::vector<FoundForm>& forms);

}  // namespace alidade
