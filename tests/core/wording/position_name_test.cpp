#include "core/wording/position_name.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(PositionName, SaysWhichTimeItIs) {
  EXPECT_EQ(positionName(0), "0°");
  EXPECT_EQ(positionName(180, 1), "180°");
  EXPECT_EQ(positionName(180, 2), "180° again");
  EXPECT_EQ(positionName(0, 3), "0° again (3)");
}

}  // namespace
}  // namespace alidade
