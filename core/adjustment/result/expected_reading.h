#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/session/measurement.h"

namespace alidade {

// The situation: readings are being taken, and the next place is known by its point, round and face. Where
// will the crosshair be? The slider comes back to the marks it was at before, in another round, face or
// position: its coordinate s there is that of the readings of the same point so far, or, of a point not yet
// seen, lies on the line through the points that are. The arc is the fitted one of the position, else that of
// another position, else the nominal one about the middle of the field. The instrument is taken for perfect:
// good enough to point by and to notice a slip of a finger, not to judge a reading by.

/// One row to be read.
struct SightingToCome {
  std::size_t position = 0;  ///< index into the session's positions
  int point = 0, round = 1, face = 1;
};

/// Where the slider is to stand by a plan, s in rad, by the session's position and the point. Points of other
/// positions with the same coordinate are then the same place, whatever their numbers.
using NominalPlaces = std::map<std::pair<std::size_t, int>, double>;

struct ExpectedReading {
  SightingToCome sighting;
  Angle horizontal, vertical;  ///< as the circles will read: in [0°, 360°), elevations in [−90°, 270°)
  Angle tolerance;             ///< readings farther from it are no accident
};

/// Absent where nothing tells of the place: no reading of that point anywhere and fewer than three points, or
/// coordinates that are not evenly spaced by number, or no pointing zero in the position. Nor are points
/// guessed at that lie beyond the known ones by more than half the length of these.
std::optional<ExpectedReading> expectedReading(const Measurement& measurement, const SessionFit& fit,
                                               const SightingToCome& sighting);

/// Of each sighting, the places of the points worked out once. Where `nominal` has a place, that is where the
/// slider stood when it was there, else its coordinate, corrected by what the slider's scale was off by so
/// far.
std::vector<std::optional<ExpectedReading>> expectedReadings(const Measurement& measurement,
                                                             const SessionFit& fit,
                                                             const std::vector<SightingToCome>& sightings,
                                                             const NominalPlaces& nominal = {});

}  // namespace alidade
