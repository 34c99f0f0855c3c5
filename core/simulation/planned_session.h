#pragma once

#include "core/session/session.h"

namespace alidade {

/// Adds simulated readings to the rows without circle readings. The guideway has the nominal radius and its
/// centre straight ahead; the readings have no error and no noise. Without a slider coordinate in the row,
/// the points of a position are spread evenly from 10° to 170°. Empty pointing zeros become 0° and straight
/// ahead. Typed entries do not change; `examine` reports invalid ones.
Session withPlannedReadings(Session session);

}  // namespace alidade
