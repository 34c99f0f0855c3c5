#include "core/wording/gap_shares.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(GapShares, AreNamedInWords) {
  EXPECT_EQ(divisionName({"frame", "guideway", 0.5}), "belongs to");
  EXPECT_EQ(divisionName({"position", "180", 0.5}), "axis at");
  EXPECT_EQ(divisionName({"face", "2", 0.5}), "face");
  EXPECT_EQ(partName({"frame", "guideway or instrument", 0.5}), "guideway or instrument");
  EXPECT_EQ(partName({"face", "2", 0.5}), "2");
  EXPECT_EQ(partName({"sector", "30…60°", 0.5}), "30…60°");
  EXPECT_EQ(partName({"time", "quarter 4", 0.5}), "4th quarter");
  EXPECT_EQ(partName({"closure", "radius", 0.5}), "the radii");
}

TEST(GapShares, TellTheClosuresOfZerosAndRepeatsFromTheResiduals) {
  EXPECT_EQ(partName({"closure", "zeros", 0.5}), "the pointing zeros");
  EXPECT_EQ(partName({"closure", "repeat", 0.5}), "positions at one axis angle");
  EXPECT_EQ(partName({"closure", "readings", 0.5}), "the residuals");
}

TEST(GapShares, NameARepeatedPositionAsElsewhere) {
  EXPECT_EQ(partName({"position", "0", 0.5}), "0°");
  EXPECT_EQ(partName({"position", "180, time 2", 0.5}), "180° again");
  EXPECT_EQ(partName({"position", "0, time 3", 0.5}), "0° again (3)");
}

/// Sessions and serial numbers are the user's, even if they are words of ours.
TEST(GapShares, LeaveNamesAsTheyAre) {
  EXPECT_EQ(partName({"session", "noise", 0.5}), "noise");
  EXPECT_EQ(partName({"instrument", "radius", 0.5}), "radius");
  EXPECT_EQ(divisionName({"session", "noise", 0.5}), "session");
}

}  // namespace
}  // namespace alidade
