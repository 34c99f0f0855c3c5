#pragma once

#include <span>

#include "core/session/measurement.h"

namespace alidade {

/// Adds whole turns to arc angles, rad, so that s follows the slider's readings without a seam: a stretched
/// scale stretches 190° by more than 170°, and not by less. `sliders`: of each angle the row with its slider
/// reading, null where there is none; its angle stays. So do all on less than half a turn. s comes out about
/// 90°, its mean in [−90°, 270°). Readings on either side of the scale's own 0° are told by the gap between
/// them.
void unwrapAlongSlider(std::span<double> arcAngles, std::span<const Sighting* const> sliders, int axisDeg);

}  // namespace alidade
