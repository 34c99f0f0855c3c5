#pragma once

#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <vector>

#include "core/observation/perfect_theodolite.h"
#include "core/session/measurement.h"

namespace alidade {

/// The mean of a visit's rows, |a|, |e| < 90°, radians.
struct VisitMean {
  Direction<double> direction;
  int rows = 1;
};

/// The rows of one visit (same round and point): the slider was at rest, so they share one arc angle.
struct Visit {
  int round = 1, point = 0;
  /// Indices into the arc's sightings, ascending: one for each face.
  boost::container::static_vector<std::size_t, 2> sightings;
  VisitMean mean;
};

/// The visits of an arc, ordered by their first row.
std::vector<Visit> visitsOf(const ArcMeasurement& arc);

/// Is the slider read anywhere on the arc?
bool hasSliderReadings(const ArcMeasurement& arc);

/// The row whose slider value counts: the first row of the visit with a slider value; null if there is none.
const Sighting* sliderOf(const ArcMeasurement& arc, const Visit& visit);

}  // namespace alidade
