#include "core/wording/measure.h"

#include <gtest/gtest.h>

#include <set>

namespace alidade {
namespace {

// The console's JSON uses these names.
TEST(MeasureInWords, HasAName) {
  std::set<std::string> names;
  for (const Measure measure :
       {Measure::BothFaces, Measure::WayBack, Measure::SliderReadings, Measure::ShiftedCircle,
        Measure::SecondStandOff, Measure::MoreOfTheArc, Measure::ZeroSightedAgain, Measure::DistanceInBoth,
        Measure::At0Again, Measure::At180Again})
    names.insert(textOf(measure));
  EXPECT_EQ(names,
            (std::set<std::string>{
                "both faces", "a return run", "slider readings",
                "a second set with the horizontal circle shifted by 60°",
                "a second set at 1.5 × the distance", "more of the arc", "the pointing zero sighted again",
                "the distance measured in both positions", "0° measured again", "180° measured again"}));
}

}  // namespace
}  // namespace alidade
