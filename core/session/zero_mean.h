#pragma once

#include <cstddef>
#include <vector>

#include "core/session/measurement.h"

namespace alidade {

/// The mean of the sightings of a pointing zero, in the same sense and relative to the same direction as
/// these.
struct ZeroMean {
  Angle a, e;
  ZeroSightings sightings = {};
};

/// The mean over the faces of the mean of each face. `sightings` are some in face 1, and if `isInBothFaces`
/// also some in face 2; else those in face 2 do not count.
ZeroMean zeroMeanOf(const std::vector<SightedZero>& sightings, bool isInBothFaces);

/// χ² of sightings about the mean of their face, with its degrees of freedom. A circle without a σ (0) does
/// not count.
class ZeroScatter {
 public:
  ZeroScatter(Angle sigmaHorizontal, Angle sigmaVertical)
      : m_horizontal(sigmaHorizontal), m_vertical(sigmaVertical) {}

  void add(const std::vector<SightedZero>& sightings);
  /// √(χ²/f), at least 1.
  double factor() const;

 private:
  Angle m_horizontal, m_vertical;
  double m_chiSquare = 0;
  int m_degreesOfFreedom = 0;
};

/// Whether the zero of an arc was sighted more than once in the face of the sighting `index`, so that the
/// others check it and a zero is left without it. False if all positions have one zero.
bool isCheckedZero(const Measurement& measurement, std::size_t arc, std::size_t index);

/// The measurement without the sighting `index` of the zero of an arc (`ArcMeasurement::zeroSightings`), for
/// which `isCheckedZero` holds. The zero is the mean of the others, and the readings of the arc refer to it.
Measurement withoutZeroSighting(Measurement measurement, std::size_t arc, std::size_t index);

}  // namespace alidade
