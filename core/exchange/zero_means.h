#pragma once

#include <string>
#include <vector>

#include "core/exchange/recording.h"
#include "core/session/measurement.h"

namespace alidade {

/// The combined reading of several sightings of one pointing zero.
struct ZeroMean {
  std::string horizontal, vertical;  ///< in a notation of `parseAngle`
  bool isMean = false;               ///< a face 1 mean; false: the first sighting as read
};

/// The mean of the sightings' face 1 equivalents. A single sighting in face 1, and angles that cannot be
/// read, stay unchanged. `sightings`: at least one.
ZeroMean zeroMean(const std::vector<const RecordedSighting*>& sightings, VerticalCircle circle);

}  // namespace alidade
