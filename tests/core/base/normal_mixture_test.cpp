#include "core/base/normal_mixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/statistics.h"

namespace alidade {
namespace {

const std::vector<NormalPart> mixture{{3, 1, 0.2}, {1, 2.5, 0.5}, {0.2, -4, 0.1}};

/// ∫ f(x) × density dx by the trapezoidal rule; for normal peaks at steps below half their σ exact to 1e-9.
template <typename Function>
double integral(const Function& f) {
  constexpr double step = 0.001, reach = 10;
  double sum = 0;
  for (double x = -reach; x < reach; x += step)
    for (const NormalPart& part : mixture)
      sum += f(x) * part.share / 4.2 * std::exp(-0.5 * std::pow((x - part.mean) / part.sigma, 2)) /
             (part.sigma * std::sqrt(2 * std::numbers::pi)) * step;
  return sum;
}

TEST(NormalMixture, HasTheMomentsOfItsDensity) {
  const MeanAndSigma moments = momentsOf(mixture);
  EXPECT_NEAR(moments.mean, integral([](double x) { return x; }), 1e-6);
  EXPECT_NEAR(std::pow(moments.sigma, 2), integral([&](double x) { return std::pow(x - moments.mean, 2); }),
              1e-6);
}

// The ends of the interval are between two steps of the integral: half a step of a density below 2.
TEST(NormalMixture, HoldsTheCoverageOfItsDensity) {
  for (const double coverage : {0.5, 0.9, 0.95, 0.99}) {
    const double half = halfWidth(mixture, 0.7, coverage);
    EXPECT_NEAR(integral([&](double x) { return std::abs(x - 0.7) <= half ? 1 : 0; }), coverage, 2e-3)
        << coverage;
  }
}

// Joining keeps the moments except for rounding, and changes the interval by at most the grain.
TEST(NormalMixture, IsHardlyAnotherWithWhatIsAlikeJoined) {
  constexpr double grain = 0.02;
  std::vector<NormalPart> fine;
  for (const NormalPart& part : mixture)
    for (int i = 0; i < 50; ++i) fine.push_back({part.share / 50, part.mean + 1e-4 * i, part.sigma});
  const std::vector<NormalPart> coarse = joined(fine, grain);
  EXPECT_LE(coarse.size(), 6U);
  EXPECT_NEAR(momentsOf(coarse).mean, momentsOf(fine).mean, 1e-12);
  EXPECT_NEAR(momentsOf(coarse).sigma, momentsOf(fine).sigma, 1e-12);
  for (const double coverage : {0.5, 0.95})
    EXPECT_NEAR(halfWidth(coarse, 0.7, coverage), halfWidth(fine, 0.7, coverage), grain) << coverage;
}

TEST(NormalMixture, OfOnePartIsThatOfTheNormalDistribution) {
  EXPECT_NEAR(halfWidth({{0.3, 5, 2}}, 5, 0.95), 2 * coverageFactor(0.95, INFINITY), 1e-5);
}

// The smaller of two distant peaks, with a tenth, must be inside except for its half that makes up 5 %. Twice
// the standard deviation, 0.6 of their distance, does not reach it.
TEST(NormalMixture, ReachesToALesserPeakThatTheCoverageNeeds) {
  const std::vector<NormalPart> two{{0.9, 0, 0.01}, {0.1, 1, 0.01}};
  const MeanAndSigma moments = momentsOf(two);
  EXPECT_NEAR(moments.mean + halfWidth(two, moments.mean, 0.95), 1, 1e-5);
  EXPECT_LT(moments.mean + 2 * moments.sigma, 0.8);
}

}  // namespace
}  // namespace alidade
