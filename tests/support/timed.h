#pragma once

#include "core/session/measurement.h"

namespace alidade::test {

/// Rows read once a minute without a pause, with zeros of unknown marks: only the rows determine drifts,
/// which are known to be linear.
inline Measurement timed(Measurement measurement) {
  for (ArcMeasurement& arc : measurement.arcs)
    for (Sighting& sighting : arc.sightings) sighting.minutes = static_cast<double>(sighting.sequence);
  measurement.zeroIs = ZeroIs::Unknown;
  setMoments(measurement);
  return measurement;
}

}  // namespace alidade::test
