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

TEST(Acceptance, SaysTheVerdictInASentence) {
  EXPECT_EQ(
      verdictSentence(1.30764, 0.2117, 2.5, 0.95),
      "The intersection was measured as 1.31 mm ± 0.21 mm (95 % coverage); it lies within the tolerance of "
      "± 2.5 mm, its uncertainty included.");
  EXPECT_NE(verdictSentence(1, 0.01, 0.5, 0.95).find("lies outside"), std::string::npos);
  EXPECT_NE(verdictSentence(1, 0.01, 1, 0.95).find("cannot be said"), std::string::npos);
}

}  // namespace
}  // namespace alidade
