#include "core/base/round_numbers.h"

#include <gtest/gtest.h>

namespace alidade::test {
namespace {

TEST(RoundNumbers, StepsAreOneTwoFive) {
  EXPECT_DOUBLE_EQ(roundDown125(199), 100);
  EXPECT_DOUBLE_EQ(roundDown125(200), 200);
  EXPECT_DOUBLE_EQ(roundDown125(0.07), 0.05);
  EXPECT_DOUBLE_EQ(roundDown125(1000), 1000);
  EXPECT_DOUBLE_EQ(roundUp125(201), 500);
  EXPECT_DOUBLE_EQ(roundUp125(501), 1000);
  EXPECT_DOUBLE_EQ(roundUp125(0.2), 0.2);
}

TEST(RoundNumbers, ForgivesRoundingErrors) {
  EXPECT_NEAR(roundDown125(0.1 + 0.1 - 1e-17), 0.2, 1e-12);
  EXPECT_NEAR(roundDown125(4.9999999999), 5, 1e-12);
  EXPECT_NEAR(roundUp125(2.0000000001), 2, 1e-12);
}

TEST(RoundNumbers, KnowsTheDecimalsOfAStep) {
  EXPECT_EQ(decimalsOfStep(100), 0);
  EXPECT_EQ(decimalsOfStep(1), 0);
  EXPECT_EQ(decimalsOfStep(0.5), 1);
  EXPECT_EQ(decimalsOfStep(0.1), 1);
  EXPECT_EQ(decimalsOfStep(0.02), 2);
}

}  // namespace
}  // namespace alidade::test
