#pragma once

#include "core/session/measurement.h"

namespace alidade::test {

/// Reads a row every minute without a pause, with unknown marks of the zeros. Drifts are then known to be
/// linear, and only the rows determine them.
inline Measurement timed(Measurement measurement) {
  for (ArcMeasurement& arc : measurement.arcs)
    for (Sighting& sighting : arc.sightings) sighting.minutes = static_cast<double>(sighting.sequence);
  measurement.zeroIs = ZeroIs::Unknown;
  setMoments(measurement);
  return measurement;
}

}  // namespace alidade::test
