#pragma once

#include <string>

#include "core/adjustment/result/session_fit.h"
#include "core/statement/statement.h"

namespace alidade {

/// The readings whose undetected error would change Δd most, five at most, then the values entered once; two
/// sentences on what checks them. Empty if no arc was fitted.
Statement reliabilityTable(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
