#pragma once

#include <string>

#include "core/adjustment/result/session_fit.h"
#include "core/statement/statement.h"

namespace alidade {

/// At most five readings, those whose undetected error changes Δd most, then the pointing zeros and lengths
/// that are entered once. Two sentences state what checks them. Empty if no arc was fitted.
Statement reliabilityTable(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
