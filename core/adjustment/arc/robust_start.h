#pragma once

#include <cstddef>
#include <vector>

#include "core/observation/guideway.h"
#include "core/session/measurement.h"

namespace alidade {

/// Where the majority of an arc's rows put the circle, and the rows and slider readings that stand apart from
/// it.
struct RobustStart {
  Circle circle;                         ///< y up, mm
  std::vector<std::size_t> apart;        ///< indices into the arc's sightings, ascending
  std::vector<std::size_t> sliderApart;  ///< rows in place whose slider reading is not
};

/// A start that up to almost half of the rows may miss by any amount: of the circles through three sighted
/// points, the one with the least median of distances (P. J. Rousseeuw, "Least median of squares regression",
/// J. Am. Stat. Assoc. 79 (1984)), refined on the rows near it. A row stands apart beyond six times the
/// scatter of that majority; that is no test yet, only where testing starts. The points are a fixed choice,
/// so the answer depends on the readings alone. With fewer than six rows nothing stands apart.
RobustStart robustStart(const Measurement& measurement, const ArcMeasurement& arc);

}  // namespace alidade
