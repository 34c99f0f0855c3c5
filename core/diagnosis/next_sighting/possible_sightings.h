#pragma once

#include <vector>

#include "core/diagnosis/result/sighting_plan.h"
#include "core/observation/guideway.h"
#include "core/session/measurement.h"

namespace alidade {

/// A candidate for the next sighting, before it is evaluated.
struct PossibleSighting {
  std::size_t arc = 0;       ///< index of the arc, which begins here if the sighting turns the axis
  std::size_t sighting = 0;  ///< index into the arc's sightings
  NextSighting next;
};

/// The session with every candidate for the next sighting. Each candidate follows the sightings taken in its
/// arc and has the moment of the next row. The last arc is the one that a turn of the axis would begin.
struct PossibleSightings {
  Measurement measurement;
  std::vector<std::size_t> taken;          ///< for each arc the number of sightings taken
  std::vector<PossibleSighting> possible;  ///< in their order in `measurement`, the current arc first
  std::size_t newArc = 0;
};

/// Rescales the elapsed shares to the duration of `rows` rows.
void countElapsedFrom(Measurement& measurement, std::size_t rows);

/// `taken` has at least one sighting.
PossibleSightings possibleSightings(const Measurement& taken, const SightingPlan& plan);

/// Gives each candidate the reading taken at its point, else an error-free one on the circle of its arc.
void sightPossible(PossibleSightings& session, const SightingPlan& plan, const std::vector<Circle>& circles);

}  // namespace alidade
