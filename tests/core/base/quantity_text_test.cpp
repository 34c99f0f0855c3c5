#include "core/base/number_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace alidade {
namespace {

TEST(QuantityText, WritesNumbersAsPeopleReadThem) {
  EXPECT_EQ(displayText(-0.8351, 3), "−0.835");
  EXPECT_EQ(displayText(-0.0001, 3), "0.000");
  EXPECT_EQ(displayText(std::numeric_limits<double>::quiet_NaN(), 3), "—");
  EXPECT_EQ(displayShortest(-2.5), "−2.5");
  EXPECT_EQ(displayShortest(2405), "2405");
}

TEST(QuantityText, ShowsUncertaintiesWithTwoSignificantDigits) {
  EXPECT_EQ(decimalsFor(0.0147), 3);
  EXPECT_EQ(decimalsFor(0.0996), 2);  // shown as 0.10
  EXPECT_EQ(decimalsFor(0.0994), 3);
  EXPECT_EQ(decimalsFor(1.4), 1);
  EXPECT_EQ(decimalsFor(12), 0);
  EXPECT_EQ(decimalsFor(12345), 0);
  EXPECT_EQ(decimalsFor(0, 3), 3);
  EXPECT_EQ(decimalsFor(std::numeric_limits<double>::infinity(), 2), 2);
}

TEST(LengthWithUncertainty, HasTheSameDecimalsInBoth) {
  EXPECT_EQ(lengthWithUncertainty(-1.30764, 0.2109, 2), "−1.31 mm ± 0.21 mm");
  EXPECT_EQ(lengthWithUncertainty(1, 0.5, 4), "1.0000 mm ± 0.5000 mm");
}

}  // namespace
}  // namespace alidade
