#include "core/wording/measure.h"

#include <utility>

#include "core/base/list_text.h"
#include "core/base/phrase.h"

namespace alidade {

namespace {

bool isEasier(const AttainableUncertainty& one, const AttainableUncertainty& other) {
  return std::pair(one.measures.size(), one.expanded) < std::pair(other.measures.size(), other.expanded);
}

}  // namespace

const AttainableUncertainty* easiestMeasured(const std::vector<AttainableUncertainty>& attainable) {
  const AttainableUncertainty* easiest = nullptr;
  for (const AttainableUncertainty& one : attainable)
    if (!one.measures.empty() && (!easiest || isEasier(one, *easiest))) easiest = &one;
  return easiest;
}

std::string textOf(Measure measure) {
  switch (measure) {
    case Measure::BothFaces:
      return Phrase::of("both faces");
    case Measure::WayBack:
      return Phrase::of("a return run");
    case Measure::SliderReadings:
      return Phrase::of("slider readings");
    case Measure::ShiftedCircle:
      return Phrase::of("a second set with the horizontal circle shifted by 60°");
    case Measure::SecondStandOff:
      return Phrase::of("a second set at 1.5 × the distance");
    case Measure::MoreOfTheArc:
      return Phrase::of("more of the arc");
    case Measure::ZeroSightedAgain:
      return Phrase::of("the pointing zero sighted again");
    case Measure::DistanceInBoth:
      return Phrase::of("the distance measured in both positions");
    case Measure::At0Again:
      return Phrase::of("0° measured again");
    case Measure::At180Again:
      return Phrase::of("180° measured again");
  }
  return "";
}

std::string textOf(const std::vector<Measure>& measures) {
  std::vector<std::string> texts;
  for (const Measure measure : measures) texts.push_back(textOf(measure));
  return listed(texts, Phrase::of(" and "));
}

std::string howTo(const std::vector<Measure>& measures) {
  return isNewSessionNeeded(measures) ? Phrase::of("%1 (in a new session)", textOf(measures))
                                      : Phrase::of("%1 (in addition)", textOf(measures));
}

}  // namespace alidade
