#include "core/wording/measure.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

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
