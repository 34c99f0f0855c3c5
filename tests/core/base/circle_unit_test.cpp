#include "core/base/angle_text.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(CompletedAngle, IsABareNumberWithTheSignOfTheUnit) {
  const auto gon = [](const char* typed) { return completedAngle(typed, CircleUnit::Gon); };
  EXPECT_EQ(gon("379.8592"), "379.8592gon");
  EXPECT_EQ(gon(" 379,8592"), " 379,8592gon");
  EXPECT_EQ(gon("−12.5"), "−12.5gon");
  EXPECT_EQ(gon("100"), "100gon");
  EXPECT_EQ(gon("3798592"), "3798592gon") << "never silently degrees, minutes and seconds";
  const auto degrees = [](const char* typed) { return completedAngle(typed, CircleUnit::Degrees); };
  EXPECT_EQ(degrees("341.8733"), "341.8733°");
  EXPECT_EQ(degrees("3415224"), "3415224") << "run together on a number pad";
  EXPECT_EQ(degrees("3415224.5"), "3415224.5");
  EXPECT_EQ(degrees("341"), "341");
}

/// Texts with a unit of their own, and texts that are not numbers, stay as typed.
TEST(CompletedAngle, LeavesEverythingElseAsTyped) {
  for (const char* typed : {"", " ", "341 52 24", "341°52'24\"", "341-52-24.5", "379.859gon", "341.8733°",
                            "12.", ".5", "1.2.3", "x", "-", "1e5", "341.52.24"})
    for (const CircleUnit unit : {CircleUnit::Dms, CircleUnit::Degrees, CircleUnit::Gon})
      EXPECT_EQ(completedAngle(typed, unit), typed);
  EXPECT_EQ(completedAngle("341.5224", CircleUnit::Dms), "341.5224") << "to be refused as ambiguous";
}

TEST(FormatAngle, WritesTheUnitToWhatStandsForDecimalsOfSeconds) {
  const Angle angle = *parseAngle("341°52'24.5\"");  // 341.873472222° = 379.859413580 gon
  EXPECT_EQ(formatAngle(angle, CircleUnit::Dms, 1), "341°52′24.5″");
  EXPECT_EQ(formatAngle(angle, CircleUnit::Degrees, 1), "341.87347°");
  EXPECT_EQ(formatAngle(angle, CircleUnit::Gon, 1), "379.85941 gon");
  EXPECT_EQ(formatAngle(angle, CircleUnit::Gon, 0), "379.8594 gon");
  EXPECT_EQ(formatAngle(-angle, CircleUnit::Degrees, 0), "−341.8735°");
}

TEST(DecimalsOf, AreThoseAnAngleWasWrittenWith) {
  EXPECT_EQ(decimalsOf(*parseAngle("341°52'24\""), CircleUnit::Dms), 0);
  EXPECT_EQ(decimalsOf(*parseAngle("341°52'24.5\""), CircleUnit::Dms), 1);
  EXPECT_EQ(decimalsOf(*parseAngle("0°00'00.05\""), CircleUnit::Dms), 2);
  EXPECT_EQ(decimalsOf(*parseAngle("-12°00'00.125\""), CircleUnit::Dms), 3);
  for (const char* typed : {"379.8592gon", "379gon", "0.1gon", "399.9999gon"})
    EXPECT_EQ(decimalsOf(*parseAngle(typed), CircleUnit::Gon), 0) << typed;
  EXPECT_EQ(decimalsOf(*parseAngle("379.85925gon"), CircleUnit::Gon), 1);
  EXPECT_EQ(decimalsOf(*parseAngle("379.8592513gon"), CircleUnit::Gon), 3);
  EXPECT_EQ(decimalsOf(*parseAngle("341.87347°"), CircleUnit::Degrees), 1);
  EXPECT_EQ(decimalsOf(*parseAngle("341°52'25\""), CircleUnit::Gon), 1) << "no decimals of gon end it";
}

}  // namespace
}  // namespace alidade
