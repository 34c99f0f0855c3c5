#pragma once

#include "core/session/session.h"

namespace alidade {

/// A session whose rows without circle readings are read in thought: on a guideway of the nominal radius, its
/// centre straight ahead, without error or noise. The slider stands where the row says, else the points of a
/// position are spread evenly from 10° to 170°. Pointing zeros left empty are 0° and straight ahead.
/// Everything that was typed stays, and what cannot be understood is left for `examine` to report.
Session withPlannedReadings(Session session);

}  // namespace alidade
