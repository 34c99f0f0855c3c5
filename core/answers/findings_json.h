#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/base/finding.h"

namespace alidade {

/// Severity, text, remedy and place of each.
nlohmann::ordered_json findingsJson(const std::vector<Finding>& findings);

}  // namespace alidade
