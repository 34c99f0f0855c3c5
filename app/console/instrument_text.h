#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/series/instrument_check/check_readings.h"
#include "core/series/instrument_check/instrument_check.h"

namespace alidade::console {

/// The check of an instrument as text, the verdict first.
std::string instrumentText(const std::string& name, const CheckIdentity& identity,
                           const InstrumentCheck& check, const std::vector<Finding>& findings);

}  // namespace alidade::console
