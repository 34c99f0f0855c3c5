#pragma once

#include "core/diagnosis/gap/gap_model.h"

namespace alidade {

/// 1 − rms after/rms before of the circle readings, arcseconds, on readings that took no part in the fit:
/// every fifth visit in turn is kept out, circles, slider zeros and all numbers of the causes are estimated
/// from the other visits, and what is kept out is predicted but for its arc angle.
///
/// What stays as all readings have it: which causes there are, the moment of a jump, which readings are
/// blamed, the widths of the priors, and the place about which the equations are linear. Readings blamed are
/// out of both fit and rms after, those alone in their visit with nothing left to check them too. Where the
/// others fix no circle nothing is predicted; not a number where nothing is at all.
double heldOutShrinkage(const GapModel& before, const GapModel& after);

}  // namespace alidade
