#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// Whether the centre's offset Δz across the plane of the arc exceeds its U.
bool isAcrossSignificant(const MeasuredIntersection& measured);

/// Returns "Across the plane of the arc its centre lies Δz = 3.01 mm ± 0.42 mm off the axis.", or that Δz was
/// not measured.
std::string acrossSentence(const MeasuredIntersection& measured);

}  // namespace alidade
