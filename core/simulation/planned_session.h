#pragma once

#include "core/session/session.h"

namespace alidade {

/// A session in which rows without circle readings get simulated ones: on a guideway of the nominal radius,
/// its centre straight ahead, without error or noise. The slider is where the row says, else the points of a
/// position are spread evenly from 10° to 170°. Empty pointing zeros become 0° and straight ahead. Typed
/// entries stay, and invalid ones are left for `examine` to report.
Session withPlannedReadings(Session session);

}  // namespace alidade
