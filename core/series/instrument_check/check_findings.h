#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/series/instrument_check/instrument_check.h"

namespace alidade {

/// The results of the check in sentences: readings left out, values that exceed scatter (95 %), causes that
/// these readings cannot distinguish, and how s compares with the stated σ and between stations.
std::vector<Finding> checkFindings(const InstrumentCheck& check);

/// `3.20″ ± 0.40″`: a value with its u, to two digits of u; a dash if the value is unknown.
std::string withU(double value, double u, const std::string& unit);

}  // namespace alidade
