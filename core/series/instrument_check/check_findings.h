#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/series/instrument_check/instrument_check.h"

namespace alidade {

/// What the check says in sentences: what took no part, what is more than scatter (95 %), what these readings
/// cannot tell apart, and how s compares with what is stated and from station to station.
std::vector<Finding> checkFindings(const InstrumentCheck& check);

/// `3.2″ ± 0.4″`: a value with its standard uncertainty, to two digits of it; a dash where there is none.
std::string withU(double value, double u, const std::string& unit);

}  // namespace alidade
