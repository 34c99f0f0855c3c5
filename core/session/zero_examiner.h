#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/problem.h"
#include "core/session/measurement.h"

namespace alidade {

// The pointing zeros of a session examined: each is the mean of its sightings, in both faces alike, before
// and after the readings of its position.

/// The pointing zero of one position, α0 and β0 as face 1 reads them.
struct ZeroDirection {
  Angle horizontal, vertical;
  ZeroSightings sightings = {};
  std::vector<SightedZero> each = {};  ///< of those that count; without their moments
};

struct ExaminedZero {
  std::optional<ZeroDirection> direction;  ///< absent where it cannot be used
  std::vector<Problem> problems;           ///< in the order of the file
};

struct ExaminedZeros {
  std::vector<ExaminedZero> ofPositions;
  double scatter = 1;           ///< `Measurement::zeroScatter`
  bool isOneOfSeveral = false;  ///< stated as one, but positions have sightings that differ
};

/// Of every position of the session. A sighting that cannot be used is left out and reported; without the
/// first, in face 1 before the readings, a position has no zero. Only faces in which all zeros were sighted
/// count, since what face 1 has of collimation and index is constant over an arc: of zeros sighted in
/// different faces, it would not cancel. Where all positions have one zero (`PointingZeros::One`), each
/// sighting stands in any of them. `circle` absent: nobody knows its kind, and there are no directions.
/// σ: of single sightings, ≥ 0.
ExaminedZeros examineZeros(const Session& session, const std::optional<VerticalCircle>& circle,
                           PointingZeros kind, Angle sigmaHorizontal, Angle sigmaVertical);

}  // namespace alidade
