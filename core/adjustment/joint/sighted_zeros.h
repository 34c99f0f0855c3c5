#pragma once

#include <cstddef>

#include "core/observation/reading_ref.h"
#include "core/session/measurement.h"

namespace alidade {

// The situation: the pointing zero of each position was sighted when the position began, and perhaps again
// after it. If the zeros are one mark and the circle was not reset, all these sightings observe one
// direction, each at its own moment. Their differences show the change of the orientation between them (a
// drift, a jump), to √2 σ of a zero. Sightings that are observations of the adjustment contribute this
// information; zeros subtracted from the readings beforehand lose it.
//
//   α_zero,i = M + (orientation at its moment) + ε_i, e_zero,i = e0 + … + ε_i
//
// with M and e0 unknown: common to all positions, or one for each position if its zero is not a common mark.

/// Are the zeros of all positions one mark? The session may state this. If it does not, they count as one
/// mark, unless all are written identically and may be a single sighting. A horizontal circle whose zeros
/// differ by more than 1° was reset, and has no common zero; a vertical circle is never reset.
CommonZeros commonZeros(const Measurement& measurement);

/// Do zeros whose mark is unstated differ by more than 30″ in either circle, horizontally at most by 1°? They
/// may then be different marks.
bool areZerosInDoubt(const Measurement& measurement);

/// The measurement with every sighting of a zero after the rows of its arc (`Sighting::isZero`). If the zeros
/// are common, all readings count from one zero. The rows keep their places.
Measurement withZerosSighted(Measurement measurement);

/// The index into `ArcMeasurement::zeroSightings` of a sighting that `withZerosSighted` added to an arc.
std::size_t indexOfZero(const ArcMeasurement& arc, std::size_t sighting);

/// Remove the sightings of zeros, and insert them again at the moments that `setMoments` gave the zeros.
void leaveOutZeros(Measurement& measurement);
void putInZeros(Measurement& measurement);

/// The stated σ of a reading of either circle, or of one sighting of a zero. The σ of a zero is at least 1e-9
/// rad: a smaller σ outweighs all other observations.
Angle sigmaOf(const Measurement& measurement, const Sighting& sighting, bool isVertical);
/// The stated σ of any reading, including the slider's.
Angle sigmaOf(const Measurement& measurement, const ReadingRef& reading);

}  // namespace alidade
