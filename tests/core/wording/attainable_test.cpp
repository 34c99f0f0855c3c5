#include "core/wording/attainable.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(AttainableSentence, NamesTheCheapestAndTheBest) {
  EXPECT_EQ(attainableSentence({}), "");
  EXPECT_EQ(attainableSentence({{.expanded = 0.234}}), "Typical U for this plan: 0.23 mm.");
  EXPECT_EQ(
      attainableSentence({{.expanded = 0.234},
                          {.measures = {Measure::SliderReadings, Measure::BothFaces}, .expanded = 0.0712},
                          {.known = "plane_warp", .expanded = 0.15},
                          {.measures = {Measure::BothFaces}, .expanded = 0.18},
                          {.measures = {Measure::SliderReadings}, .expanded = 0.2},
                          {.measures = {Measure::MoreOfTheArc}, .expanded = 0.21}}),
      "Typical U for this plan: 0.234 mm; 0.180 mm with both faces, 0.200 mm with slider readings, "
      "0.071 mm with slider readings and both faces; 0.150 mm with plane warp known.");
  EXPECT_EQ(
      attainableSentence({{.expanded = 2},
                          {.measures = {Measure::SliderReadings}, .expanded = 1},
                          {.measures = {Measure::SliderReadings, Measure::BothFaces}, .expanded = 1.5}}),
      "Typical U for this plan: 2.0 mm; 1.0 mm with slider readings, 1.5 mm with slider readings and "
      "both faces.");
}

TEST(EasiestMeasured, TakesTheFewestMeasuresAndThenBringsTheMost) {
  EXPECT_FALSE(easiestMeasured({}));
  const std::vector<AttainableUncertainty> nothingToRead{{.expanded = 0.2},
                                                         {.known = "plane_warp", .expanded = 0.1}};
  EXPECT_FALSE(easiestMeasured(nothingToRead));
  const std::vector<AttainableUncertainty> list{
      {.expanded = 0.2},
      {.measures = {Measure::SliderReadings, Measure::BothFaces}, .expanded = 0.05},
      {.measures = {Measure::WayBack}, .expanded = 0.18},
      {.measures = {Measure::BothFaces}, .expanded = 0.15}};
  EXPECT_EQ(easiestMeasured(list), &list[3]);
}

}  // namespace
}  // namespace alidade
