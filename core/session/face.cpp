#include "core/session/face.h"

#include "core/base/phrase.h"

namespace alidade {

FaceOneReading inFaceOne(Angle horizontal, Angle vertical, int face, VerticalCircle circle) {
  if (face == 1) return {horizontal, vertical};
  const Angle turn = Angle::fromDegrees(circle == VerticalCircle::Zenith ? 360 : 180);
  return {horizontal - Angle::fromDegrees(180), turn - vertical};
}

bool isFaceTwo(Angle vertical, VerticalCircle circle) {
  const double degrees = wrapped(vertical, Angle::fromDegrees(180)).degrees();
  return circle == VerticalCircle::Zenith ? degrees > 180 : degrees > 90 && degrees < 270;
}

std::string faceName(int face) {
  if (face == 1) return Phrase::of("face 1");
  if (face == 2) return Phrase::of("face 2");
  return Phrase::of("face %1", face);
}

}  // namespace alidade
