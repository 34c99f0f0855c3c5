#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"

namespace alidade::console {

/// The block "Findings"; empty where there are none.
std::string findingsText(const std::vector<Finding>& findings);

}  // namespace alidade::console
