#pragma once

#include <cstddef>
#include <vector>

#include "core/adjustment/foot_point.h"

namespace alidade {

/// The rows of one visit (same round and point): the slider stood still, so they share one arc angle.
struct Visit {
  int round = 1, point = 0;
  std::vector<std::size_t> sightings;  ///< indices into the arc's sightings, in the order taken
  VisitMean mean;
};

/// The visits of an arc, ordered by their first row.
std::vector<Visit> visitsOf(const ArcMeasurement& arc);

}  // namespace alidade
