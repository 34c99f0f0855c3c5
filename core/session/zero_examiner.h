#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/problem.h"
#include "core/session/measurement.h"

namespace alidade {

// The examination of the pointing zeros of a session: each zero is the mean of its sightings before and after
// the readings of its position, with both faces weighted equally.

/// The pointing zero of one position, α0 and β0 converted to face 1.
struct ZeroDirection {
  Angle horizontal, vertical;
  ZeroSightings sightings = {};
  std::vector<SightedZero> each = {};  ///< the sightings that count, without their moments
};

struct ExaminedZero {
  std::optional<ZeroDirection> direction;  ///< absent if it cannot be used
  std::vector<Problem> problems;           ///< in the order of the file
};

struct ExaminedZeros {
  std::vector<ExaminedZero> ofPositions;
  double scatter = 1;           ///< `Measurement::zeroScatter`
  bool isOneOfSeveral = false;  ///< stated as one, but the sightings of positions differ
};

/// Examines the zeros of every position. An unusable sighting is left out and reported. A position has no
/// zero if its first sighting, in face 1 before the readings, is unusable. Face 2 counts only if the zeros of
/// all positions were sighted in it: zeros in different faces would not cancel the effect of collimation and
/// index, which is constant over an arc in face 1. If all positions have one zero (`PointingZeros::One`),
/// each sighting may be entered in any position. If `circle` is absent, the kind of the vertical circle is
/// unknown and there are no directions. The σ are those of single sightings, ≥ 0.
ExaminedZeros examineZeros(const Session& session, const std::optional<VerticalCircle>& circle,
                           PointingZeros kind, Angle sigmaHorizontal, Angle sigmaVertical);

/// The largest angle between sightings of one zero, in degrees, including all errors of the instrument.
inline constexpr double farthestZeroSighting = 0.5;

/// The problem of a sighting, as typed, that is `degrees` from the first.
Problem zeroApartProblem(const std::string& text, double degrees);

/// The largest angle between a zero and the horizon, in degrees: a steeper zero is nearer to the horizon of
/// the other kind of vertical circle.
inline constexpr double steepestZero = 45;

/// The elevation of a zero above the horizon. Absent beyond `steepestZero`: the circle is of the other kind,
/// or reads 0 neither at the zenith nor at the horizon.
std::optional<Angle> zeroElevation(Angle vertical, VerticalCircle circle);

}  // namespace alidade
