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

/// `fitArcFast` for an arc's visits: y of the circle counts from the horizon (`ZeroLine::height`).
std::optional<FastArcFit> fitVisitsFast(const Measurement& measurement, const std::vector<Visit>& visits,
                                        const ZeroLine& line);

/// The start of a joint adjustment of all arcs: `fitArc`, or the fast fit if it is reliable for the arc. The
/// fast fit gives no residuals; its cofactor and χ² have the accuracy of `FastArcFit`.
Result<ArcFit, ArcFault> firstFit(const Measurement& measurement, const ArcMeasurement& arc);

}  // namespace alidade
