#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/diagnosis/result/form.h"

namespace alidade {

/// Returns an entry of the array `forms` of a result, and the array.
nlohmann::ordered_json formDocument(const FoundForm& found);
nlohmann::ordered_json formsJson(const std::vector<FoundForm>& forms);

}  // namespace alidade
