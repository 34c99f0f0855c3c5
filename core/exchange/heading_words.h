#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// What a word in the heading of a column can say. One word may say several things: `m` are metres or
/// minutes.
enum class HeadingRole {
  Axis,
  Turn,
  Station,
  Point,
  Numbering,  ///< a number or a name: of the point where nothing else names one
  Round,
  Face,
  Horizontal,
  MaybeHorizontal,  ///< where nothing else does: `H` is a height as well
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
  GonMinutePart,  ///< of a hundredth of a gon
  GonSecondPart,
  FaceOne,
  FaceTwo,
  SpanishCircle,  ///< whose D and I are directo and inverso
  Metre,
  Millimetre,
  DistanceWord,  ///< says nothing beside a distance: `slope`
  CircleWord,    ///< names the face where nothing else stands beside it: `круг`
  Filler,        ///< says nothing: `angle`, `reading`
};

/// `word` as `headingWords` gives it.
bool means(HeadingRole role, std::string_view word);

/// The words of a heading, folded (folded_text.h): parted by blanks and punctuation; the signs ° ' " and #
/// are words of their own, and what is written without blanks (水平角读数) is parted where known words end.
std::vector<std::string> headingWords(std::string_view heading);

}  // namespace alidade
