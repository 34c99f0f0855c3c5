#pragma once

#include "core/observation/reading_ref.h"
#include "core/session/measurement.h"

namespace alidade {

// The situation: the pointing zero of each position was sighted when the position began, and perhaps again
// behind it. Where the zeros are one mark, and the circle was not set anew, all these sightings observe one
// direction, each at its own moment: what they differ by is what the orientation did between them (a drift,
// a knock), good to √2 σ of a zero. As observations of the adjustment they say so; taken off the readings
// beforehand they say nothing.
//
//   α_zero,i = M + (orientation at its moment) + ε_i,     e_zero,i = e0 + … + ε_i
//
// with M and e0 unknown: common to all positions, or of each position where its zero is no common mark.

/// Do the zeros sight one mark? As it is stated; unstated, it is taken so, unless all zeros are written alike
/// and may be a single sighting. The directions of circles that were set anew have nothing in common: of such
/// as differ by more than a degree.
CommonZeros commonZeros(const Measurement& measurement);

/// Zeros that are not stated to be a mark differ by more than 30″ in either circle: they may be none.
bool areZerosInDoubt(const Measurement& measurement);

/// The measurement with every sighting of a zero behind the rows of its arc (`Sighting::isZero`), and the
/// readings counted from one zero where the zeros are common. The rows keep their places.
Measurement withZerosSighted(Measurement measurement);

/// The same sightings taken out again, or put in anew at the moments that `setMoments` gave the zeros.
void leaveOutZeros(Measurement& measurement);
void putInZeros(Measurement& measurement);

/// σ of a reading of either circle, or of one sighting of a zero, as it is stated: never
/// taken as exact, and what sightings differ by beyond it is for the model to say.
Angle sigmaOf(const Measurement& measurement, const Sighting& sighting, bool isVertical);
/// Of the slider, too.
Angle sigmaOf(const Measurement& measurement, const ReadingRef& reading);

}  // namespace alidade
