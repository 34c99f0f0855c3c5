#include "core/base/histogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "core/base/statistics.h"

namespace alidade::test {
namespace {

std::size_t counted(const Histogram& histogram) {
  return std::accumulate(histogram.counts.begin(), histogram.counts.end(), histogram.outside);
}

TEST(Histogram, CountsEveryValueOnce) {
  const std::vector<double> values{-9.9, -3, -2, -1.5, -0.5, 0, 0.1, 0.9, 1, 2.5, 3.999, 4, 25};
  const Histogram histogram = alidade::histogram(values, 10);
  EXPECT_EQ(counted(histogram), values.size());
  EXPECT_EQ(histogram.outside, 1u) << "25";
  // The middle half is −1.5 … 2.5: 2 · 4/13^⅓ = 3.4, rounded up to 5.
  EXPECT_DOUBLE_EQ(histogram.width, 5);
  EXPECT_DOUBLE_EQ(histogram.lower(0), -10);
  EXPECT_EQ(histogram.counts, (std::vector<std::size_t>{1, 4, 7, 0}));
}

TEST(Histogram, ItsLimitsBelongToTheUpperClassButForTheLast) {
  const Histogram histogram = alidade::histogram(std::vector<double>{-1, 0, 1}, 1);
  ASSERT_TRUE(histogram.classOf(0));
  EXPECT_DOUBLE_EQ(histogram.lower(*histogram.classOf(0)), 0);
  EXPECT_EQ(histogram.classOf(-1), 0u);
  EXPECT_EQ(histogram.classOf(1), histogram.counts.size() - 1);
  EXPECT_EQ(histogram.outside, 0u);
}

// Freedman and Diaconis: 2 · 1.349 σ n^(−⅓) = 0.27 σ of a thousand normal values.
TEST(Histogram, ItsClassesAreThoseOfFreedmanAndDiaconis) {
  std::vector<double> values;
  for (int i = 1; i <= 1000; ++i) values.push_back(4 * normalQuantile((i - 0.5) / 1000));
  const Histogram histogram = alidade::histogram(values, 16);
  EXPECT_DOUBLE_EQ(histogram.width, 2) << "1.08, rounded up";
  const std::vector<NormalValues> normal{{1000, 4}};
  for (std::size_t i = 0; i < histogram.counts.size(); ++i)
    EXPECT_NEAR(static_cast<double>(histogram.counts[i]),
                expectedBetween(normal, histogram.lower(i), histogram.lower(i + 1)), 1)
        << i;
}

TEST(Histogram, HasFewClassesEvenWithOneValueFarAway) {
  std::vector<double> values(100, 0.0);
  values.push_back(3600);
  const Histogram histogram = alidade::histogram(values, 4000);
  EXPECT_LE(histogram.counts.size(), 62u);
  EXPECT_EQ(counted(histogram), 101u);
  EXPECT_EQ(alidade::histogram({}, 10).largestCount(), 0u);
}

// Φ(1) − Φ(−1) = 0.682 689 492 (Abramowitz and Stegun, table 26.1).
TEST(Histogram, ExpectsNormalValuesByTheirSigma) {
  const std::vector<NormalValues> values{{100, 2}, {50, 5}};
  EXPECT_NEAR(expectedBetween({values.data(), 1}, -2, 2), 68.2689492, 1e-6);
  EXPECT_NEAR(expectedBetween(values, -1e3, 1e3), 150, 1e-9);
  EXPECT_NEAR(expectedBetween({values.data() + 1, 1}, -5, 5), 34.1344746, 1e-6);
}

}  // namespace
}  // namespace alidade::test
