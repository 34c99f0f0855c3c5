#pragma once

#include <cstddef>
#include <vector>

#include "core/observation/guideway.h"
#include "core/session/measurement.h"

namespace alidade {

/// The circle of the majority of an arc's rows, and the rows and slider readings that deviate from it.
struct RobustStart {
  Circle circle;                         ///< y up, mm
  std::vector<std::size_t> apart;        ///< indices into the arc's sightings, ascending
  std::vector<std::size_t> sliderApart;  ///< rows on the circle whose slider reading deviates
};

/// A start that tolerates errors of any size in almost half of the rows: of the circles through three sighted
/// points, the one with the least median of distances (P. J. Rousseeuw, "Least median of squares regression",
/// J. Am. Stat. Assoc. 79 (1984)), refined on the rows near it. Rows beyond six times the scatter of that
/// majority are candidates for tests. A fixed rule chooses the points, so that the result depends only on the
/// readings. With fewer than six rows there are no candidates.
RobustStart robustStart(const Measurement& measurement, const ArcMeasurement& arc);

}  // namespace alidade
