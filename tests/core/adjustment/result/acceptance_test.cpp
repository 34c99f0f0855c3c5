#include "core/adjustment/result/acceptance.h"

#include <gtest/gtest.h>

#include <limits>

namespace alidade {
namespace {

TEST(Acceptance, GuardsBothSidesWithTheUncertainty) {
  EXPECT_EQ(decide(0.5, 0.2, 1), Verdict::Accept);
  EXPECT_EQ(decide(-0.5, 0.2, 1), Verdict::Accept);
  EXPECT_EQ(decide(0.75, 0.25, 1), Verdict::Accept);  // just fits
  EXPECT_EQ(decide(0.875, 0.25, 1), Verdict::Undecided);
  EXPECT_EQ(decide(1.125, 0.25, 1), Verdict::Undecided);
  EXPECT_EQ(decide(1.25, 0.25, 1), Verdict::Undecided);  // not yet beyond
  EXPECT_EQ(decide(1.375, 0.25, 1), Verdict::Reject);
  EXPECT_EQ(decide(-1.375, 0.25, 1), Verdict::Reject);
}

TEST(Acceptance, NeverDecidesOnNumbersThatAreNone) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(decide(nan, 0.1, 1), Verdict::Undecided);
  EXPECT_EQ(decide(0.1, nan, 1), Verdict::Undecided);
  EXPECT_EQ(decide(0.1, inf, 1), Verdict::Undecided);
}

}  // namespace
}  // namespace alidade
