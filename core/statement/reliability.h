#pragma once

#include <string>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/result/session_fit.h"
#include "core/statement/statement.h"

namespace alidade {

/// At most five readings, those whose undetected error changes Δd most, then the pointing zeros and lengths
/// that are entered once. Two sentences state what checks them. Empty if no arc was fitted.
Statement reliabilityTable(const Measurement& measurement, const SessionFit& fit);

/// The readings that look misread, the most certain first: each with its deviation and the probable
/// intention, other intentions as parts.
Statement suspectTable(const std::vector<Suspect>& suspects);

}  // namespace alidade
