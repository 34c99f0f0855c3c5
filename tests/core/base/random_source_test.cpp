#include "core/base/random_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace alidade {
namespace {

// Computed independently in Python from the published definitions of SplitMix64 and xoshiro256++.
TEST(RandomSource, FollowsThePublishedGenerator) {
  RandomSource random(42, 7);
  EXPECT_EQ(random.bits(), 0xd9893fc677d6169u);
  EXPECT_EQ(random.bits(), 0x8c202a1a1dd3b94du);
  EXPECT_EQ(random.bits(), 0xb20f071eca7887c8u);
}

// Sample moments of 10⁵ numbers within 5 of their standard deviations.
TEST(RandomSource, HasTheMomentsOfANormalVariable) {
  RandomSource random(1);
  constexpr int count = 100000;
  double sum = 0, squares = 0, fourth = 0;
  for (int i = 0; i < count; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / count, 0, 5 / std::sqrt(count));
  EXPECT_NEAR(squares / count, 1, 5 * std::sqrt(2.0 / count));
  EXPECT_NEAR(fourth / count, 3, 5 * std::sqrt(96.0 / count));
}

TEST(RandomSource, GivesEveryStreamItsOwnNumbers) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 30; ++seed)
    for (std::uint64_t stream = 0; stream < 30; ++stream)
      EXPECT_TRUE(seen.insert(RandomSource(seed, stream).bits()).second) << seed << " " << stream;
}

TEST(RandomSource, DrawsWholeNumbersInTheirRange) {
  RandomSource random(5);
  std::set<int> seen;
  for (int i = 0; i < 200; ++i) seen.insert(random.whole(-1, 3));
  EXPECT_EQ(seen, (std::set<int>{-1, 0, 1, 2, 3}));
  EXPECT_EQ(random.whole(4, 4), 4);
}

}  // namespace
}  // namespace alidade
