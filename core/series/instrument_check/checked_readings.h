#pragma once

#include "core/base/result.h"
#include "core/series/instrument_check/check_readings.h"
#include "core/series/instrument_check/instrument_check.h"

namespace alidade {

/// Checks the readings station by station. If a figure is implausible (`implausibility`), fails and names the
/// lines: a wrong figure is worse than none.
Result<InstrumentCheck> checkReadings(const CheckReadings& readings, const CheckOptions& options = {});

}  // namespace alidade
