#pragma once

#include <string>

#include "core/series/instrument_check/instrument_check.h"
#include "core/session/instrument_record.h"

namespace alidade {

/// An instrument record of what a check tells for sessions to come: σ of a
/// reading in one face, √2 times the pooled s, and collimation, index and, where elevations show it, trunnion
/// tilt with u, in arcseconds. Of several stations the mean weighted by 1/u², its u larger where they differ
/// by more. The collimation is that without tilt and e/D where these were fitted. `date`: year-month-day, of
/// the check.
InstrumentRecord checkedRecord(const InstrumentCheck& check, const std::string& name,
                               const std::string& serial, const std::string& date);

}  // namespace alidade
