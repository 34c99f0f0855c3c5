#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/discover.h"

namespace alidade::console {

/// Returns the forms with their look-alikes and the shrinkage of the gap; empty without forms.
std::string formsText(const std::vector<FoundForm>& forms);
/// The result of `discover` as text. `table` is the name of the table of residuals.
std::string discoveryText(const std::string& table, const Discovery& discovery);

}  // namespace alidade::console
