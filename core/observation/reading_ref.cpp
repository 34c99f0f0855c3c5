#include "core/observation/reading_ref.h"

#include "core/base/phrase.h"

namespace alidade {

std::string_view nameOf(ReadingKind kind) {
  switch (kind) {
    case ReadingKind::Horizontal:
      return "horizontal";
    case ReadingKind::Vertical:
      return "vertical";
    case ReadingKind::Slider:
      break;
  }
  return "slider";
}

std::string inWords(ReadingKind kind) {
  switch (kind) {
    case ReadingKind::Horizontal:
      //: the kind of a reading, in a list: "0°, point 11, horizontal"
      return Phrase::of("horizontal");
    case ReadingKind::Vertical:
      //: the kind of a reading, in a list: "0°, point 11, vertical"
      return Phrase::of("vertical");
    case ReadingKind::Slider:
      break;
  }
  //: the kind of a reading, in a list: "0°, point 11, slider"
  return Phrase::of("slider");
}

Angle statedSigma(const Measurement& measurement, ReadingKind kind) {
  if (kind == ReadingKind::Horizontal) return measurement.sigmaHorizontal;
  return kind == ReadingKind::Vertical ? measurement.sigmaVertical : measurement.sigmaSlider;
}

double sideOf(const Measurement& measurement, int face, ReadingKind kind) {
  if (kind != ReadingKind::Vertical) return 1;
  const double down = measurement.verticalCircle == VerticalCircle::Zenith ? -1 : 1;
  return face == 1 ? down : -down;
}

}  // namespace alidade
