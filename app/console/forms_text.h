#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/discover.h"

namespace alidade::console {

/// The forms with their look-alikes and how far the gap shrinks; empty where there is none.
std::string formsText(const std::vector<FoundForm>& forms);
/// The result of `discover`; `table` names it.
std::string discoveryText(const std::string& table, const Discovery& discovery);

}  // namespace alidade::console
