#pragma once

#include "core/diagnosis/gap/gap_model.h"

namespace alidade {

/// Returns 1 − rms after/rms before of held-out circle readings. Every fifth visit in turn is held out.
/// Circles, slider zeros and the parameters of the causes are estimated from the other visits. These
/// estimates predict the held-out readings; each held-out visit keeps an arc angle of its own.
///
/// Some choices come from all readings: the causes, the moment of a jump, the readings with gross errors, the
/// prior widths and the point of linearisation. Readings with gross errors are excluded from the fit and from
/// rms after, and so is the only remaining reading of a visit. Folds whose complement determines no circle
/// are skipped. Not a number if no fold remains.
double heldOutShrinkage(const GapModel& before, const GapModel& after);

}  // namespace alidade
