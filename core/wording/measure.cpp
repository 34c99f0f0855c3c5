#include "core/wording/measure.h"

#include "core/base/list_text.h"

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
    case Measure::DistanceInBoth:
      return "the distance measured in both positions";
    case Measure::At0Again:
      return "0° measured again";
    case Measure::At180Again:
      return "180° measured again";
  }
  return "";
}

std::string textOf(const std::vector<Measure>& measures) {
  std::vector<std::string> texts;
  for (const Measure measure : measures) texts.push_back(textOf(measure));
  return listed(texts, " and ");
}

std::string howTo(const std::vector<Measure>& measures) {
  return textOf(measures) + (isReadAnew(measures) ? " (read anew)" : " (in addition)");
}

}  // namespace alidade
