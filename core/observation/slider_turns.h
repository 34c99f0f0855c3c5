#pragma once

#include <span>

#include "core/session/measurement.h"

namespace alidade {

/// The zero of the slider's scale, rad: the mean direction of reading − s. Arguments as in
/// `unwrapAlongSlider`.
double sliderZero(std::span<const double> arcAngles, std::span<const Sighting* const> sliders, int axisDeg);

/// Unwraps arc angles, rad, by whole turns so that s follows the slider's readings continuously: the effect
/// of a scale error is proportional to s. `sliders`: for each angle the row with its slider reading. An angle
/// with a null row is unchanged; all are unchanged if they span less than half a turn. s is centred near 90°,
/// with its mean in [−90°, 270°). The widest gap shows which readings are beyond the scale's own 0°.
void unwrapAlongSlider(std::span<double> arcAngles, std::span<const Sighting* const> sliders, int axisDeg);

}  // namespace alidade
