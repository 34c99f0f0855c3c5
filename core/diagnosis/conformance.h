#pragma once

#include <optional>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

// How probably a measurand lies within its tolerance, 0…1, by what is believed of it (JCGM 106:2012, 7.4).
// Absent without degrees of freedom or an uncertainty.

/// |Δd| ≤ `tolerance`, mm.
std::optional<double> conformanceOf(const IntersectionEstimate& estimate, double tolerance);

/// √(Δd² + Δz²) ≤ `tolerance`, mm, Δz as uncertain as Student's variable and independent of Δd.
std::optional<double> conformanceOf(const IntersectionEstimate& inPlane, const MeasuredLength& across,
                                    double tolerance);

}  // namespace alidade
