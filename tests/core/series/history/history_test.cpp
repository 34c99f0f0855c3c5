#include "core/series/history/history.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace alidade {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

DatedValue at(double day, double value, double u) {
  return {std::to_string(day), day, value, u, u, {}};
}

/// Returns values of one level, a month apart, with noise of `scatter` times their u.
std::vector<DatedValue> stable(std::mt19937_64& generator, std::size_t count, double scatter = 1,
                               bool unequal = false) {
  std::normal_distribution<double> normal;
  std::vector<DatedValue> values;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = unequal ? std::exp(0.7 * normal(generator)) : 1;
    values.push_back(at(30.0 * static_cast<double>(i), scatter * u * normal(generator), u));
  }
  return values;
}

std::vector<DatedValue> stepped(std::mt19937_64& generator, std::size_t count, std::size_t first,
                                double size) {
  std::vector<DatedValue> values = stable(generator, count);
  for (std::size_t i = first; i < count; ++i) values[i].value += size;
  return values;
}

// Student's factors t(1) = 12.706 and t(2) = 4.303 for an observed scatter, 1.960 for a stated one. Two
// values 0.2 apart have a mean of u = 0.1.
TEST(History, WidensUByTheDegreesOfFreedomOfAnObservedScatter) {
  const History two = historyOf({at(0, 1, 0.02), at(365, 1.2, 0.02)});
  EXPECT_NEAR(two.mean.scatteredExpanded, 12.706 * 0.1, 1e-4);
  EXPECT_NEAR(two.mean.expanded, 1.960 * 0.02 / std::sqrt(2), 1e-5);
  const History four =
      historyOf({at(0, 1, 0.02), at(365, 1.16, 0.02), at(731, 1.5, 0.02), at(1096, 1.62, 0.02)});
  EXPECT_NEAR(four.trend->expanded / four.trend->u, 4.303, 1e-3);
  const History exact = historyOf({at(0, 1, 0.02), at(365, 1.1, 0.02), at(730, 1.2, 0.02)});
  EXPECT_NEAR(exact.trend->expanded / exact.trend->u, 1.960, 1e-3);
}

TEST(History, HasTheMeanAndMisfitOfTheClosedForms) {
  // w = 1, 1/4, 1: mean (10 + 12/4 + 13)/2.25, χ² by hand.
  const History history = historyOf({at(0, 10, 1), at(10, 12, 2), at(20, 13, 1)});
  EXPECT_DOUBLE_EQ(history.mean.value, 26 / 2.25);
  EXPECT_DOUBLE_EQ(history.mean.u, std::sqrt(1 / 2.25));
  const double m = 26 / 2.25;
  const double chiSquare = std::pow(10 - m, 2) + std::pow(12 - m, 2) / 4 + std::pow(13 - m, 2);
  EXPECT_NEAR(history.chiSquare, chiSquare, 1e-12);
  EXPECT_EQ(history.degreesOfFreedom, 2);
  EXPECT_NEAR(*history.chance, std::exp(-chiSquare / 2), 1e-12);  // χ² with two degrees of freedom
  EXPECT_NEAR(history.birgeRatio, std::sqrt(chiSquare / 2), 1e-12);
}

// The sixteen determinations of G used in CODATA's adjustment of 2018 (Tiesinga and others, Rev. Mod. Phys.
// 93, 025010, table XXIX): weighted mean 6.674 30e-11, Birge ratio 3.6. Three small correlations are ignored
// here. They and the rounding of the printed values change the mean by one and a half of its last digit.
TEST(History, OfNewtonsConstantIsAsPublished) {
  const std::vector<std::array<double, 3>> published = {
      {1982, 6.67248, 0.00043},   {1996, 6.6729, 0.0005},   {1997, 6.67398, 0.00070},
      {2000, 6.674255, 0.000092}, {2001, 6.67559, 0.00027}, {2002, 6.67422, 0.00098},
      {2003, 6.67387, 0.00027},   {2005, 6.67222, 0.00087}, {2006, 6.67425, 0.00012},
      {2009, 6.67349, 0.00018},   {2010, 6.67260, 0.00025}, {2014, 6.67554, 0.00016},
      {2014, 6.67191, 0.00099},   {2014, 6.67435, 0.00013}, {2018, 6.674184, 0.000078},
      {2018, 6.674484, 0.000077}};
  std::vector<DatedValue> values;
  for (const auto& [year, value, u] : published) values.push_back(at((year - 2000) * 365.25, value, u));
  const History history = historyOf(values);
  EXPECT_NEAR(history.mean.value, 6.67430, 0.000015);
  EXPECT_NEAR(history.birgeRatio, 3.6, 0.1);
  EXPECT_LT(*history.chance, 1e-20);
  EXPECT_FALSE(*history.stable);
  EXPECT_THAT(history.steps, IsEmpty());  // they scatter, but G does not change in steps
  EXPECT_NEAR(history.mean.scattered, history.birgeRatio * history.mean.u, 1e-12);
}

TEST(History, OfOneValueComparesNothing) {
  const History history = historyOf({at(0, 3, 0.1)});
  EXPECT_EQ(history.mean.value, 3);
  EXPECT_EQ(history.chiSquare, 0);
  EXPECT_FALSE(history.chance);
  EXPECT_FALSE(history.stable);
  EXPECT_FALSE(history.trend);
  EXPECT_THAT(history.courses, IsEmpty());
}

TEST(History, OfTwoValuesTellsTheirDifference) {
  const History history = historyOf({at(0, 1, 0.3), at(365.25, 2, 0.4)});
  EXPECT_NEAR(history.chiSquare, 4, 1e-12);  // (1/0.5)²
  EXPECT_NEAR(history.trend->perYear, 1, 1e-12);
  EXPECT_NEAR(history.trend->u, 0.5, 1e-12);
  EXPECT_FALSE(*history.stable);
  EXPECT_TRUE(*historyOf({at(0, 1, 0.3), at(365.25, 1.5, 0.4)}).stable);
}

TEST(History, HasTheTrendOfTheNormalEquations) {
  const std::vector<DatedValue> values = {at(0, 1, 0.1), at(100, 1.3, 0.2), at(500, 2, 0.1),
                                          at(900, 2.2, 0.3)};
  double w = 0, t = 0, x = 0, tt = 0, tx = 0;
  for (const DatedValue& value : values) {
    const double weight = 1 / (value.u * value.u), years = value.day / 365.25;
    w += weight;
    t += weight * years;
    x += weight * value.value;
    tt += weight * years * years;
    tx += weight * years * value.value;
  }
  const double determinant = w * tt - t * t, rate = (w * tx - t * x) / determinant,
               level = (tt * x - t * tx) / determinant;
  double chiSquare = 0;
  for (const DatedValue& value : values)
    chiSquare += std::pow((value.value - level - rate * value.day / 365.25) / value.u, 2);
  const History history = historyOf(values);
  EXPECT_NEAR(history.trend->perYear, rate, 1e-12);
  EXPECT_NEAR(history.trend->stated, std::sqrt(w / determinant), 1e-12);
  EXPECT_NEAR(history.trend->u, std::sqrt(w / determinant * std::max(1.0, chiSquare / 2)), 1e-12);
}

TEST(History, FindsAStepWithItsDateAndSize) {
  const History history =
      historyOf({at(0, 1.00, 0.01), at(60, 1.01, 0.01), at(120, 0.99, 0.01), at(180, 1.005, 0.01),
                 at(240, 1.06, 0.01), at(300, 1.07, 0.01), at(360, 1.055, 0.01), at(420, 1.065, 0.01)});
  EXPECT_EQ(history.course, Course::Steps);
  ASSERT_THAT(history.steps, SizeIs(1));
  EXPECT_EQ(history.steps[0].first, 4u);
  EXPECT_EQ(history.steps[0].date, history.values[4].date);
  EXPECT_NEAR(history.steps[0].size, 1.0625 - 1.00125, 1e-12);
  EXPECT_NEAR(history.steps[0].u, 0.01 / std::sqrt(2), 1e-12);
  EXPECT_EQ(history.levels.size(), 2u);
  EXPECT_FALSE(*history.stable);
}

TEST(History, PrefersATrendToSteps) {
  std::mt19937_64 generator(5);
  std::vector<DatedValue> values = stable(generator, 20);
  for (std::size_t i = 0; i < values.size(); ++i) values[i].value += 0.5 * static_cast<double>(i);
  const History history = historyOf(values);
  EXPECT_EQ(history.course, Course::Trend);
  EXPECT_THAT(history.steps, IsEmpty());
  EXPECT_NEAR(history.trend->perYear, 0.5 * 365.25 / 30, 4 * history.trend->u);
}

TEST(History, TakesOneValueFarOffForThat) {
  std::mt19937_64 generator(6);
  std::vector<DatedValue> values = stable(generator, 15);
  values[7].value += 15;
  const History history = historyOf(values);
  EXPECT_EQ(history.course, Course::OddValue);
  EXPECT_EQ(history.oddValue, 7u);
  EXPECT_THAT(history.steps, IsEmpty());
}

TEST(History, TellsWanderingFromSteps) {
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal;
  std::vector<DatedValue> values = stable(generator, 40);
  double level = 0;
  for (DatedValue& value : values) value.value += level += 2 * normal(generator);
  EXPECT_EQ(historyOf(values).course, Course::Wander);
}

TEST(History, NeverPartsValuesOfOneDate) {
  std::vector<DatedValue> values;
  for (int i = 0; i < 5; ++i)
    for (const double off : {-1.0, 1.0}) values.push_back(at(i, off + (i > 2 ? 20 : 0), 1));
  const History history = historyOf(values);
  ASSERT_THAT(history.steps, SizeIs(1));
  EXPECT_EQ(history.steps[0].first, 6u);
}

TEST(History, DoesNotHangOnOrderUnitsOrOrigin) {
  std::mt19937_64 generator(8);
  const std::vector<DatedValue> values = stepped(generator, 12, 7, 6);
  const History history = historyOf(values);
  ASSERT_THAT(history.steps, SizeIs(1));
  std::vector<DatedValue> other = values;
  std::shuffle(other.begin(), other.end(), generator);
  EXPECT_EQ(historyOf(other).chiSquare, history.chiSquare);
  for (const auto& [scale, shift] : {std::pair(1e-11, 0.0), std::pair(1e6, 0.0), std::pair(-1.0, 1000.0)}) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      other[i] = values[i];
      other[i].value = values[i].value * scale + shift;
      other[i].u = other[i].apart = values[i].u * std::abs(scale);
    }
    const History changed = historyOf(other);
    ASSERT_THAT(changed.steps, SizeIs(1));
    EXPECT_EQ(changed.steps[0].first, history.steps[0].first);
    EXPECT_NEAR(changed.steps[0].size / scale, history.steps[0].size, 1e-9);
    EXPECT_NEAR(changed.chiSquare, history.chiSquare, 1e-7);
    // Rounding of the shifted values also affects the probabilities.
    EXPECT_NEAR(changed.courses[0].probability, history.courses[0].probability, 1e-7);
  }
}

TEST(History, LeavesWhatIsSharedToTheMean) {
  const History alone = historyOf({at(0, 1, 1), at(1, 2, 1)}),
                shared = historyOf({at(0, 1, 1), at(1, 2, 1)}, 3);
  EXPECT_EQ(shared.chiSquare, alone.chiSquare);
  EXPECT_NEAR(shared.mean.u, std::sqrt(0.5 + 9), 1e-12);
}

// With the odds in the header, 2000 draws give a false report in 0.0 to 0.3 % for each; 2 % of 600 is 12.
TEST(History, SeldomTellsAChangeWhereThereIsNone) {
  std::mt19937_64 generator(9);
  for (const std::size_t count : {3, 4, 6, 10, 20, 60})
    for (const bool unequal : {false, true}) {
      int changed = 0, unstable = 0;
      for (int draw = 0; draw < 600; ++draw) {
        const History history = historyOf(stable(generator, count, 1, unequal));
        changed += history.course != Course::Constant ? 1 : 0;
        unstable += *history.stable ? 0 : 1;
      }
      EXPECT_LE(changed, 12) << count;
      EXPECT_LE(unstable, 50) << count;  // 5 % is 30, with a spread of 5.3
    }
}

// Values that scatter three times as much as stated: 5 % of 600 is 30; observed 0 to 5.4 %.
TEST(History, TakesUnderstatedUncertaintiesForThatRatherThanForSteps) {
  std::mt19937_64 generator(10);
  for (const std::size_t count : {3, 4, 6, 10, 20, 60}) {
    int steps = 0;
    for (int draw = 0; draw < 600; ++draw)
      steps += historyOf(stable(generator, count, 3)).course == Course::Steps ? 1 : 0;
    EXPECT_LE(steps, 48) << count;
  }
}

// Observed: 97, 98 and 99.7 % of 2000 draws.
TEST(History, SeldomMissesAStepOfSixU) {
  std::mt19937_64 generator(11);
  for (const std::size_t count : {10, 20, 60}) {
    int right = 0;
    for (int draw = 0; draw < 200; ++draw) {
      const History history = historyOf(stepped(generator, count, count / 2, 6));
      right += history.steps.size() == 1 && history.steps[0].first == count / 2 ? 1 : 0;
    }
    EXPECT_GE(right, 180) << count;
  }
}

TEST(ControlChart, WatchesWhatFollowsItsBaseline) {
  History history =
      historyOf({at(0, 1, 0.1), at(1, 1.2, 0.2), at(2, 1.1, 0.1), at(3, 1.5, 0.1), at(4, 1.2, 0.3)});
  const HistoryMean before = history.mean;
  setBaseline(history, 3);
  const ControlChart& chart = history.chart;
  EXPECT_EQ(chart.baseline, 3U);
  EXPECT_NEAR(chart.centre, (100 * 1 + 25 * 1.2 + 100 * 1.1) / 225, 1e-12);
  EXPECT_NEAR(chart.centreU, 1 / 15.0, 1e-12);
  EXPECT_NEAR(chart.seenSigma, (0.2 + 0.1) / 2 / 1.128379, 1e-6) << "of the baseline only";
  EXPECT_NEAR(chart.points[0].shewhart, 0.3, 1e-12);
  EXPECT_NEAR(chart.points[3].shewhart, 3 * std::hypot(0.1, 1 / 15.0), 1e-12);
  EXPECT_TRUE(chart.points[3].isOut);
  EXPECT_FALSE(chart.points[4].isOut);
  // The average begins at the centre line; u_c has the weight of the values averaged so far.
  EXPECT_NEAR(chart.points[3].ewma, chart.centre + 0.2 * (1.5 - chart.centre), 1e-12);
  EXPECT_NEAR(chart.points[3].ewmaLimit, 3 * 0.2 * std::hypot(0.1, 1 / 15.0), 1e-12);
  EXPECT_NEAR(chart.points[4].ewmaLimit,
              3 * std::sqrt(std::pow(0.2 * 0.3, 2) + std::pow(0.8 * 0.2 * 0.1, 2) + std::pow(0.36 / 15.0, 2)),
              1e-12);
  EXPECT_EQ(history.mean.value, before.value) << "the conclusions are of all values";
}

TEST(ControlChart, TakesAnyNumberOfValuesForItsBaseline) {
  for (const std::size_t count : {1U, 2U, 7U}) {
    std::vector<DatedValue> values;
    for (std::size_t i = 0; i < count; ++i)
      values.push_back(at(static_cast<double>(i), 1 + static_cast<double>(i), 0.5));
    History history = historyOf(values);
    EXPECT_EQ(history.chart.baseline, count) << "unless one is chosen, all";
    for (const std::size_t baseline : {0U, 1U, 2U, 7U, 8U}) {
      setBaseline(history, baseline);
      EXPECT_EQ(history.chart.baseline, baseline == 0 || baseline > count ? count : baseline);
      EXPECT_EQ(history.chart.points.size(), count);
      EXPECT_EQ(std::isnan(history.chart.seenSigma), history.chart.baseline == 1);
    }
  }
}

TEST(ControlChart, HasLimitsForEachValue) {
  const History history = historyOf({at(0, 1, 0.1), at(1, 2, 0.2), at(2, 1, 0.1)});
  const double mean = (100 + 2 * 25 + 100) / 225.0;
  ASSERT_THAT(history.chart.points, SizeIs(3));
  EXPECT_NEAR(history.chart.points[1].shewhart, 0.6, 1e-12);
  EXPECT_TRUE(history.chart.points[1].isOut);
  EXPECT_FALSE(history.chart.points[0].isOut);
  EXPECT_NEAR(history.chart.seenSigma, 1 / 1.128, 1e-3);
  // The average begins at the mean; its variance is Σ (λ (1 − λ)^(n−i) u_i)².
  double z = 0, variance = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    z = 0.2 * (history.values[i].value - mean) + 0.8 * z;
    variance = 0;
    for (std::size_t j = 0; j <= i; ++j)
      variance += std::pow(0.2 * std::pow(0.8, static_cast<double>(i - j)) * history.values[j].u, 2);
    EXPECT_NEAR(history.chart.points[i].ewma, mean + z, 1e-12);
    EXPECT_NEAR(history.chart.points[i].ewmaLimit, 3 * std::sqrt(variance), 1e-12);
  }
}

}  // namespace
}  // namespace alidade
