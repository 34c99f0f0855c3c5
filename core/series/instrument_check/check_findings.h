#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/series/instrument_check/instrument_check.h"

namespace alidade {

/// The results of the check in sentences: readings left out, values that exceed scatter (95 %), causes these
/// readings cannot distinguish, and how s compares with the stated σ and between stations.
std::vector<Finding> checkFindings(const InstrumentCheck& check);

/// `3.2″ ± 0.4″`: a value with its standard uncertainty, to two digits of the latter; a dash if it has none.
std::string withU(double value, double u, const std::string& unit);

}  // namespace alidade
