#include "core/diagnosis/evidence/width.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/diagnosis/evidence/gain.h"

namespace alidade {
namespace {

/// Sums probabilities, not their logarithms.
double sumOfChances(const std::vector<Width>& widths) {
  double sum = 0;
  for (const Width& width : widths) sum += std::exp(width.logChance);
  return sum;
}

// Sums of a few numbers below 1: 1e-14 is some fifty rounding errors.
TEST(Width, IsSureToBeOneOfThoseGiven) {
  for (const std::vector<Width>& widths : {evenly({2}), evenly({0.1, 3}), evenly({8, 30, 120, 1000, 1e6})}) {
    EXPECT_NEAR(sumOfChances(widths), 1, 1e-14);
    EXPECT_NEAR(sumOfChances(andFarWider(widths, 1e7)), 1, 1e-14);
    EXPECT_NEAR(sumOfChances(andFarWider(andFarWider(widths, 1e7), 1e8)), 1, 1e-14);
  }
}

TEST(Width, KeepsTheOrderOfThoseGiven) {
  const std::vector<Width> widths = andFarWider(evenly({3, 0.1, 1}), 300);
  ASSERT_EQ(widths.size(), 4u);
  const double sigmas[] = {3, 0.1, 1, 300};
  for (std::size_t i = 0; i < widths.size(); ++i) EXPECT_EQ(widths[i].sigma, sigmas[i]) << i;
}

// One in a hundred; the ratios of the others stay the same.
TEST(Width, FarGreaterOneTakesFromAllAlike) {
  const std::vector<Width> uneven{{0.3, std::log(0.2)}, {1, std::log(0.7)}, {2, std::log(0.1)}};
  const std::vector<Width> wider = andFarWider(uneven, 50);
  const double chances[] = {0.198, 0.693, 0.099, 0.01};
  ASSERT_EQ(wider.size(), 4u);
  for (std::size_t i = 0; i < wider.size(); ++i)
    EXPECT_NEAR(std::exp(wider[i].logChance), chances[i], 1e-15) << i;
}

// The evidence is the mean over the widths. So a width given twice equals that width, and the order of 1 and
// 4 does not matter. The gain of 18 is a sum of a dozen numbers: 1e-12.
TEST(Width, GivenTwiceIsThatWidth) {
  const Eigen::MatrixXd gram = Eigen::MatrixXd::Constant(1, 1, 2);
  const Eigen::VectorXd right = Eigen::VectorXd::Constant(1, 9);
  const auto gain = [&](const std::vector<Width>& widths) { return gainOf(widths, gram, right, 1).log; };
  EXPECT_NEAR(gain(evenly({3, 3})), gain(evenly({3})), 1e-12);
  EXPECT_NEAR(gain(evenly({1, 4})), gain(evenly({4, 1})), 1e-12);
  EXPECT_NEAR(gain(evenly({1, 4})), std::log((std::exp(gain(evenly({1}))) + std::exp(gain(evenly({4})))) / 2),
              1e-12);
}

}  // namespace
}  // namespace alidade
