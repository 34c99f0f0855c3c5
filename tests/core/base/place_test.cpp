#include "core/base/problem.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(Place, NamesTheSpotAsTheSessionFileDoes) {
  EXPECT_EQ((Place{.position = 1, .reading = 3, .field = "vertical"}).path(),
            "positions[1].readings[3].vertical");
  EXPECT_EQ((Place{.position = 1, .field = "pointing_zero.vertical"}).path(),
            "positions[1].pointing_zero.vertical");
  EXPECT_EQ((Place{.position = 0, .reading = 2}).path(), "positions[0].readings[2]");
  EXPECT_EQ((Place{.position = 0}).path(), "positions[0]");
  EXPECT_EQ((Place{.field = "geometry.distance_mm"}).path(), "geometry.distance_mm");
  EXPECT_EQ(Place{}.path(), "");
}

}  // namespace
}  // namespace alidade
