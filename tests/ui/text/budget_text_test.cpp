#include "ui/text/budget_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace alidade::ui {
namespace {

MeasuredIntersection measuredBy(std::vector<UncertaintyShare> budget) {
  double variance = 0;
  for (const UncertaintyShare& share : budget) variance += share.sigma * share.sigma;
  return {.estimate = {.value = 1, .sigma = std::sqrt(variance)}, .budget = std::move(budget)};
}

TEST(BudgetText, NamesEachSourceWithItsSizeAndUnit) {
  const QVector<BudgetLine> lines = budgetLines(
      measuredBy({{.effect = "horizontal_circle_eccentricity",
                   .from = UncertaintyShare::From::Default,
                   .sigma = 3,
                   .sizes = {{"sine", 10, "arcsec"}, {"cosine", 12, "arcsec"}}},
                  {.from = UncertaintyShare::From::Diagnosis, .sigma = 2},
                  {.source = UncertaintySource::Readings, .type = UncertaintyShare::Type::A, .sigma = 1}}));
  ASSERT_EQ(lines.size(), 3);
  EXPECT_EQ(lines[0].source, QStringLiteral("horizontal circle eccentricity"));
  EXPECT_EQ(lines[0].sizes, QStringLiteral("10, 12″"));
  EXPECT_EQ(lines[0].from, QStringLiteral("default"));
  EXPECT_EQ(lines[1].source, QStringLiteral("what else may explain the readings"));
  EXPECT_EQ(lines[1].type, QStringLiteral("B"));
  EXPECT_EQ(lines[2].source, QStringLiteral("readings"));
  EXPECT_EQ(lines[2].type, QStringLiteral("A"));
  EXPECT_TRUE(lines[2].sizes.isEmpty());
  const QVector<BudgetLine> known = budgetLines(measuredBy({{.effect = "collimation",
                                                             .from = UncertaintyShare::From::Known,
                                                             .sigma = 1,
                                                             .reference = "check\x1b 7"}}));
  EXPECT_EQ(known[0].from, QStringLiteral("check\\u001b 7")) << "as the session says it";
}

TEST(BudgetText, GathersWhatIsBelowHalfAPercentOfTheVariance) {
  const UncertaintyShare little{.effect = "plane_warp", .sigma = 0.03},
      less{.effect = "arc_lobing", .sigma = 0.04};
  const QVector<BudgetLine> lines =
      budgetLines(measuredBy({{.source = UncertaintySource::Readings, .sigma = 2}, less, little}));
  ASSERT_EQ(lines.size(), 2);
  EXPECT_EQ(lines[1].source, QStringLiteral("2 others"));
  EXPECT_DOUBLE_EQ(lines[1].sigma, 0.05);
  const QVector<BudgetLine> one =
      budgetLines(measuredBy({{.source = UncertaintySource::Readings, .sigma = 2}, little}));
  EXPECT_EQ(one.last().source, QStringLiteral("plane warp")) << "one alone is no crowd";
}

TEST(BudgetText, CountsDegreesOfFreedomWhileThatTellsAnything) {
  EXPECT_EQ(degreesOfFreedomText(7.25), QStringLiteral("7.2"));
  EXPECT_EQ(degreesOfFreedomText(196.4), QStringLiteral("196"));
  EXPECT_EQ(degreesOfFreedomText(1e4), QStringLiteral("10000"));
  EXPECT_EQ(degreesOfFreedomText(269372), QStringLiteral("many"));
  EXPECT_EQ(degreesOfFreedomText(std::numeric_limits<double>::infinity()), QStringLiteral("∞"));
}

TEST(BudgetText, StatesNoShareOfNothing) {
  EXPECT_EQ(shareText(1, 2), QStringLiteral("25.0 %"));
  EXPECT_EQ(shareText(0, 0), QStringLiteral("—"));
}

}  // namespace
}  // namespace alidade::ui
