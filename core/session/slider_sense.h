#pragma once

#include "core/session/measurement.h"

namespace alidade {

/// Whether the slider readings of an arc decrease where its slider coordinate s increases: with the arc angle
/// at 0°, against it at 180°. The circles alone show it. False with too few readings, or too short an arc.
bool runsAgainstSlider(const ArcMeasurement& arc);

}  // namespace alidade
