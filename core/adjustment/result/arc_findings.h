#pragma once

#include <vector>

#include "core/adjustment/arc/arc_fit.h"
#include "core/adjustment/result/fit_finding.h"

namespace alidade {

/// Findings on an arc that was fitted: no redundancy, the same reading typed twice, scatter that contradicts
/// the stated noise, a short arc, a radius far from the nominal one, no convergence.
std::vector<FitFinding> arcFindings(const Measurement& measurement, const ArcMeasurement& arc,
                                    const ArcFit& fit);

}  // namespace alidade
