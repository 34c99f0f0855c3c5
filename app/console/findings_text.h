#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"

namespace alidade::console {

/// The block "Findings"; empty without findings.
std::string findingsText(const std::vector<Finding>& findings);

}  // namespace alidade::console
