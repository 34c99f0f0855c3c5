#pragma once

#include "core/session/measurement.h"

namespace alidade::test {

/// Read a row a minute, without a pause, by zeros of which nobody knows whether they sight one mark: drifts
/// are told by the rows alone, and known to go on evenly.
inline Measurement timed(Measurement measurement) {
  for (ArcMeasurement& arc : measurement.arcs)
    for (Sighting& sighting : arc.sightings) sighting.minutes = static_cast<double>(sighting.sequence);
  measurement.zeroIs = ZeroIs::Unknown;
  setMoments(measurement);
  return measurement;
}

}  // namespace alidade::test
