#include "core/exchange/recording.h"

#include <gtest/gtest.h>

#include "core/base/angle_text.h"

namespace alidade::test {
namespace {

TEST(LineProblem, NamesLineAndColumn) {
  EXPECT_EQ((LineProblem{3, 12, "is odd"}).text(), "line 3, column 12: is odd");
  EXPECT_EQ((LineProblem{3, 0, "is odd"}).text(), "line 3: is odd");
}

TEST(WithUnit, TellsPlainNumbersTheirUnit) {
  EXPECT_EQ(withUnit("341,873", AngleUnit::Degrees), "341,873°");
  EXPECT_EQ(withUnit(" 379.859 ", AngleUnit::Gon), "379.859gon");
  EXPECT_EQ(withUnit("-12", AngleUnit::Gon), "-12gon");
  EXPECT_EQ(withUnit("341.5224", AngleUnit::Dms), "341 52 24");
  EXPECT_EQ(withUnit("341.5", AngleUnit::Dms), "341 50 00");
  EXPECT_EQ(withUnit("341.52245", AngleUnit::Dms), "341 52 24.5");
  EXPECT_EQ(withUnit("341", AngleUnit::Dms), "341 00 00");
  EXPECT_NEAR(parseAngle(withUnit("-0.3000", AngleUnit::Dms))->degrees(), -0.5, 1e-12);
}

TEST(WithUnit, LeavesTheRestAlone) {
  EXPECT_EQ(withUnit("379.859", AngleUnit::Unstated), "379.859");
  for (const char* text : {"341°52'24\"", "341 52 24", "12.3.4", "", "-", ".", "12gon", "1-2"})
    for (const AngleUnit unit : {AngleUnit::Degrees, AngleUnit::Gon, AngleUnit::Dms})
      EXPECT_EQ(withUnit(text, unit), text);
}

}  // namespace
}  // namespace alidade::test
