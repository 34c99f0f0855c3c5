#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// The possible meanings of a word in the heading of a column. One word may have several meanings: `m` is
/// metres or minutes.
enum class HeadingRole {
  Axis,
  Turn,
  Station,
  Point,
  Numbering,  ///< a number or a name; the point, unless another heading names it
  Round,
  Face,
  Horizontal,
  MaybeHorizontal,  ///< the horizontal circle, unless another heading names it: `H` is also a height
  Vertical,
  MaybeVertical,
  Zenith,
  Elevation,
  Slider,
  Distance,
  HorizontalDistance,
  Corrections,
  Excluded,
  Note,
  Tilt,
  CrossTilt,
  LengthTilt,
  Arcseconds,
  Gon,
  Degrees,
  Grad,  ///< degrees in German, gon in French
  Radians,
  Dms,
  DegreePart,
  MinutePart,
  SecondPart,
  GonMinutePart,  ///< a hundredth of a gon
  GonSecondPart,
  FaceOne,
  FaceTwo,
  SpanishCircle,  ///< Spanish, so that D and I mean directo and inverso
  Metre,
  Millimetre,
  DistanceWord,  ///< has a meaning only in a distance: `slope`
  CircleWord,    ///< names the face if nothing else in the heading does: `круг`
  Filler,        ///< without a meaning of its own: `angle`, `reading`
};

/// Does `word`, as `headingWords` gives it, have this meaning?
bool means(HeadingRole role, std::string_view word);

/// The words of a heading, folded (`foldedText`) and split at blanks and punctuation. The signs ° ' " and #
/// are words of their own; text without blanks (水平角读数) is split where known words end.
std::vector<std::string> headingWords(std::string_view heading);

}  // namespace alidade
