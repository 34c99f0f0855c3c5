#include "core/wording/measure.h"

namespace alidade {

std::string textOf(Measure measure) {
  switch (measure) {
    case Measure::BothFaces:
      return "both faces";
    case Measure::WayBack:
      return "the way back";
    case Measure::SliderReadings:
      return "slider readings";
    case Measure::ShiftedCircle:
      return "a second set with the horizontal circle shifted by 60°";
    case Measure::SecondStandOff:
      return "a second set from half as far again";
    case Measure::MoreOfTheArc:
      return "more of the arc";
    case Measure::ZeroSightedAgain:
      return "the pointing zero sighted again";
  }
  return "";
}

}  // namespace alidade
