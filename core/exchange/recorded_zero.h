#pragma once

#include <optional>
#include <vector>

#include "core/exchange/recording.h"
#include "core/session/measurement.h"

namespace alidade {

/// A sighting of a pointing zero in a file.
struct ZeroInFile {
  const RecordedSighting* sighting;
  bool isAfter = false;  ///< taken after most of the position's readings
};

/// A pointing zero put together from the sightings in files.
struct RecordedZero {
  /// Several sightings in the same face, before or after the readings, that became their mean.
  struct Mean {
    std::vector<const RecordedSighting*> of;
    int face = 1;
    bool isAfter = false;
  };
  /// A sighting too far from the first for one direction (`farthestZeroSighting`).
  struct Apart {
    const RecordedSighting* sighting;
    bool isVertical = false;
    double degrees = 0;
  };

  PointingZero zero;
  std::vector<Mean> means = {};
  bool isConverted = false;  ///< sighted in face 2 only, and converted to face 1
  std::optional<Apart> apart = {};
};

/// Puts each sighting in its place in the zero, by face and by time. If none is in face 1 before the
/// readings, the first entry is in face 1 after them, else the sightings in face 2 converted to face 1.
/// Angles that cannot be read stay as they are, in the first entry. `sightings`: at least one, in the order
/// taken.
RecordedZero recordedZero(const std::vector<ZeroInFile>& sightings, VerticalCircle circle);

}  // namespace alidade
