#pragma once

#include <vector>

#include "core/diagnosis/result/sighting_plan.h"
#include "core/observation/guideway.h"
#include "core/session/measurement.h"

namespace alidade {

/// A sighting that could be next, without its worth.
struct PossibleSighting {
  std::size_t arc = 0;  ///< begins with it if it turns the axis
  NextSighting next;
};

/// The session with every sighting that could be next. Those stand after the sightings taken in their arcs,
/// with the moment of the next row; the arc that a turn of the axis would begin is the last.
struct PossibleSightings {
  Measurement measurement;
  std::vector<std::size_t> taken;          ///< for each arc the number of sightings taken
  std::vector<PossibleSighting> possible;  ///< in the order in which they stand
  std::size_t newArc = 0;
};

/// Counts the elapsed shares from the duration of so many rows.
void countElapsedFrom(Measurement& measurement, std::size_t rows);

PossibleSightings possibleSightings(const Measurement& taken, const SightingPlan& plan);

/// Gives the possible sightings error-free readings on these circles, one for each arc.
void sightPossible(PossibleSightings& session, const SightingPlan& plan, const std::vector<Circle>& circles);

}  // namespace alidade
