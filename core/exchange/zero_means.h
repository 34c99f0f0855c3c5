#pragma once

#include <string>
#include <vector>

#include "core/exchange/recording.h"
#include "core/session/measurement.h"

namespace alidade {

/// What several sightings of one pointing zero come to.
struct ZeroMean {
  std::string horizontal, vertical;  ///< in a notation of `parseAngle`
  bool isMean = false;               ///< in face 1; else as the first sighting has it
};

/// The mean of their face 1 equivalents; a single sighting in face 1, and angles that cannot be read, stay as
/// they are. `sightings`: at least one.
ZeroMean zeroMean(const std::vector<const RecordedSighting*>& sightings, VerticalCircle circle);

}  // namespace alidade
