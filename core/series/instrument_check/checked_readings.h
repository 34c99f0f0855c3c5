#pragma once

#include "core/base/result.h"
#include "core/series/instrument_check/check_readings.h"
#include "core/series/instrument_check/instrument_check.h"

namespace alidade {

/// The check of the readings, station by station. Fails, with the lines, where a figure cannot be right
/// (`implausibility`): a wrong figure is worse than none.
Result<InstrumentCheck> checkReadings(const CheckReadings& readings, const CheckOptions& options = {});

}  // namespace alidade
