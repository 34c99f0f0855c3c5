#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/base/finding.h"

namespace alidade {

/// Returns severity, text, remedy and place of each finding.
nlohmann::ordered_json findingsJson(const std::vector<Finding>& findings);

}  // namespace alidade
