#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/base/finding.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/form.h"

namespace alidade {

/// `[{"measure": "", "known": "", "expanded_mm": 0.23}, {"measure": "slider readings", …}, …]`
nlohmann::ordered_json attainableJson(const std::vector<AttainableUncertainty>& attainable);

/// Returns severity, text, remedy and place of each finding.
nlohmann::ordered_json findingsJson(const std::vector<Finding>& findings);

/// Returns an entry of the array `forms` of a result, and the array.
nlohmann::ordered_json formDocument(const FoundForm& found);
nlohmann::ordered_json formsJson(const std::vector<FoundForm>& forms);

}  // namespace alidade
