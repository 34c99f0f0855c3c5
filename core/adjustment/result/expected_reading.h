#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/session/measurement.h"

namespace alidade {

// The situation: readings are being taken, and the next visit is known by its point, round and face. What
// will the circles read? The slider returns to earlier marks in another round, face or position. Its
// coordinate s at a known point follows from earlier readings of the point; at a new point, from the line
// through the known points. The arc is the fitted arc of the position, else of another position, else the
// nominal arc about the middle of the field. A perfect instrument is assumed, which suffices for pointing and
// for detecting typing errors, but not for judging a reading.

/// One row that is still to be read.
struct SightingToCome {
  std::size_t position = 0;  ///< index into the session's positions
  int point = 0, round = 1, face = 1;
};

/// The planned slider coordinate s, rad, by the index of the session's position and the number of the point.
/// Points with the same s are the same place, whatever their position and number.
using NominalPlaces = std::map<std::pair<std::size_t, int>, double>;

struct ExpectedReading {
  SightingToCome sighting;
  Angle horizontal, vertical;  ///< as the circles read: in [0°, 360°), elevations in [−90°, 270°)
  Angle tolerance;             ///< a larger deviation is significant
};

/// Returns the expected reading of each sighting. It is absent if the place cannot be predicted or the
/// position has no pointing zero. A place cannot be predicted if the point has no reading anywhere, and there
/// are fewer than three points or coordinates not evenly spaced by number. Points are extrapolated by at most
/// half the range of the known point numbers. A place in `nominal` has the coordinate of the slider's earlier
/// visit. Without an earlier visit, it has the nominal coordinate, corrected by the slider's mean offset.
std::vector<std::optional<ExpectedReading>> expectedReadings(const Measurement& measurement,
                                                             const SessionFit& fit,
                                                             const std::vector<SightingToCome>& sightings,
                                                             const NominalPlaces& nominal = {});

}  // namespace alidade
