#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/series/instrument_check/instrument_check.h"

namespace alidade::console {

/// The check of an instrument as text.
std::string instrumentText(const std::string& name, const InstrumentCheck& check,
                           const std::vector<Finding>& findings);

}  // namespace alidade::console
