#include "core/adjustment/result/uncertain_length.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace alidade {
namespace {

// A long vector has the uncertainty along its direction: 3-4-5 with the gradient (3/5, 4/5).
TEST(UncertainLength, OfALongVectorIsThatAlongIt) {
  const UncertainLength length =
      lengthOf({.x = 300, .y = 400, .varianceX = 0.04, .varianceY = 0.01, .covariance = 0.01});
  EXPECT_DOUBLE_EQ(length.value, 500);
  EXPECT_NEAR(length.sigma, std::sqrt(0.36 * 0.04 + 0.64 * 0.01 + 2 * 0.48 * 0.01), 1e-6);
}

TEST(UncertainLength, OfNothingIsThatInBothDirections) {
  const UncertainLength length = lengthOf({.varianceX = 0.09, .varianceY = 0.16});
  EXPECT_EQ(length.value, 0);
  EXPECT_DOUBLE_EQ(length.sigma, 0.5);
}

// The scatter of lengths of drawn vectors, from seven times their uncertainty on: the next order of the
// expansion is some (u/|v|)², 2 %, and 200 000 draws determine the scatter to 0.2 %. For a shorter vector it
// is at least the scatter.
TEST(UncertainLength, IsTheScatterOfLengths) {
  std::mt19937_64 generator(1);
  std::normal_distribution<double> normal;
  constexpr int draws = 200'000;
  constexpr double along = 0.1, across = 0.3, tilt = 0.7;
  for (const double size : {0.0, 0.3, 0.9, 2.0}) {
    const double c = std::cos(tilt), s = std::sin(tilt);
    double sum = 0, squares = 0;
    for (int i = 0; i < draws; ++i) {
      const double u = size + along * normal(generator), v = across * normal(generator);
      sum += std::hypot(u, v);
      squares += u * u + v * v;
    }
    const double scatter = std::sqrt(squares / draws - sum / draws * sum / draws);
    const double sigma = lengthOf({.x = size * c,
                                   .y = size * s,
                                   .varianceX = along * along * c * c + across * across * s * s,
                                   .varianceY = along * along * s * s + across * across * c * c,
                                   .covariance = (along * along - across * across) * c * s})
                             .sigma;
    EXPECT_GE(sigma, 0.99 * scatter) << size;
    if (size >= 2) {
      EXPECT_NEAR(sigma / scatter, 1, 0.02) << size;
    }
  }
}

}  // namespace
}  // namespace alidade
