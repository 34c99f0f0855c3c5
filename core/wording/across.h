#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// Whether the centre's offset Δz across the plane of the arc exceeds its U.
bool isAcrossSignificant(const MeasuredIntersection& measured);

/// Returns "The arc's centre is Δz = 3.01 mm ± 0.42 mm off the axis, across the plane of the arc.", or a
/// sentence that Δz was not measured.
std::string acrossSentence(const MeasuredIntersection& measured);

}  // namespace alidade
