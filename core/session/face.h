#pragma once

#include <string>

#include "core/base/angle.h"
#include "core/session/measurement.h"

namespace alidade {

/// Both circles converted to face 1; the angles are not wrapped.
struct FaceOneReading {
  Angle horizontal, vertical;
};

/// A reading of `face` 1 or 2 as its face 1 equivalent. Face 2: α − 180°; 360° − β on a zenith circle, 180° −
/// β on an elevation circle, whose readings continue beyond 90° at the zenith when the telescope is turned
/// through.
FaceOneReading inFaceOne(Angle horizontal, Angle vertical, int face, VerticalCircle circle);

/// Was this vertical circle reading taken with the telescope turned through? Face 2 is beyond 180° on a
/// zenith circle, between 90° and 270° on an elevation circle.
bool isFaceTwo(Angle vertical, VerticalCircle circle);

/// "face 1", "face 2", in the language of the thread.
std::string faceName(int face);

}  // namespace alidade
