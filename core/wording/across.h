#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// Across the plane of the arc the centre lies off the axis by more than U.
bool liesOff(const MeasuredIntersection& measured);

/// "Across the plane of the arc its centre lies Δz = 3.01 mm ± 0.42 mm off the axis.", or that it was not
/// measured.
std::string acrossSentence(const MeasuredIntersection& measured);

}  // namespace alidade
