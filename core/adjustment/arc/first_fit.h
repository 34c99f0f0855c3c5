#pragma once

#include <optional>
#include <vector>

#include "core/adjustment/arc/arc_fit.h"
#include "core/adjustment/arc/fast_arc_fit.h"
#include "core/base/result.h"
#include "core/observation/visits.h"
#include "core/observation/zero_line.h"
#include "core/session/measurement.h"

namespace alidade {

/// `fitArcFast` of an arc's visits: its y counts from the horizon (`ZeroLine::height`).
std::optional<FastArcFit> fitVisitsFast(const Measurement& measurement, const std::vector<Visit>& visits,
                                        const ZeroLine& line);

/// What an adjustment of all arcs together starts from: as `fitArc`, but where the fast fit is sure of the
/// arc there are no residuals yet, and cofactor and χ² are as good as that has them.
Result<ArcFit, ArcFault> firstFit(const Measurement& measurement, const ArcMeasurement& arc);

}  // namespace alidade
