#pragma once

#include <string>

#include "core/series/instrument_check/instrument_check.h"
#include "core/session/instrument_record.h"

namespace alidade {

/// An instrument record from the check, for later sessions. σ of a reading in one face is √2 times the pooled
/// s. The record holds collimation, index and, if stated, trunnion tilt of all stations with u, arcsec. It
/// also holds the offset of the line of sight with its u, in mm, and its correlation with the collimation.
/// `identity` states the day of the check.
InstrumentRecord checkedRecord(const InstrumentCheck& check, const CheckIdentity& identity);

}  // namespace alidade
