#include "core/statement/budget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/diagnose.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

Diagnosis measuredBy(std::vector<UncertaintyShare> budget) {
  double variance = 0;
  for (const UncertaintyShare& share : budget) variance += share.sigma * share.sigma;
  Diagnosis diagnosis;
  diagnosis.measured = MeasuredIntersection{.estimate = {.value = 1, .sigma = std::sqrt(variance)},
                                            .budget = std::move(budget)};
  return diagnosis;
}

Statement stated(std::vector<UncertaintyShare> budget) {
  return measuredBudget(measuredBy(std::move(budget)), 0.95);
}

/// The cell of a row in the column with this id.
std::string cell(const Statement& statement, std::size_t row, const std::string& id) {
  for (std::size_t i = 0; i < statement.columns.size(); ++i)
    if (statement.columns[i].id == id) return statement.rows.at(row).cells.at(i);
  return "no such column";
}

TEST(BudgetStatement, NamesEachSourceWithItsSizeAndUnit) {
  const Statement budget =
      stated({{.effect = "horizontal_circle_eccentricity",
               .from = UncertaintyShare::From::Default,
               .sigma = 3,
               .sizes = {{"sine", 10, "arcsec"}, {"cosine", 12, "arcsec"}}},
              {.from = UncertaintyShare::From::Diagnosis, .sigma = 2},
              {.source = UncertaintySource::Readings, .type = UncertaintyShare::Type::A, .sigma = 1}});
  ASSERT_EQ(budget.rows.size(), 5u) << "three sources and two totals";
  EXPECT_EQ(cell(budget, 0, "source"), "horizontal circle eccentricity");
  EXPECT_EQ(cell(budget, 0, "size"), "10, 12″");
  EXPECT_EQ(cell(budget, 0, "from"), "default");
  EXPECT_EQ(cell(budget, 0, "share"), "64.3 %") << "9 of 14";
  EXPECT_EQ(cell(budget, 1, "source"), "other possible explanations");
  EXPECT_EQ(cell(budget, 1, "type"), "B");
  EXPECT_EQ(cell(budget, 2, "source"), "readings");
  EXPECT_EQ(cell(budget, 2, "type"), "A");
  EXPECT_EQ(cell(budget, 2, "size"), "");
  EXPECT_TRUE(budget.rows[3].isTotal);
  EXPECT_EQ(cell(budget, 3, "u"), "3.74") << "√14, with a digit more than u needs";
  EXPECT_EQ(cell(budget, 3, "share"), "100.0 %");
}

TEST(BudgetStatement, StatesSensitivityDegreesOfFreedomAndCoverageFactor) {
  const Statement budget =
      stated({{.effect = "plane_offset", .sigma = 0.4, .sizes = {{"offset", 0.8, "mm"}}},
              {.effect = "collimation", .sigma = 0.3, .sizes = {{"angle", 10, "arcsec"}}},
              {.effect = "horizontal_circle_eccentricity",
               .sigma = 0.2,
               .sizes = {{"sine", 10, "arcsec"}, {"cosine", 12, "arcsec"}}},
              {.source = UncertaintySource::Readings,
               .type = UncertaintyShare::Type::A,
               .sigma = 0.1,
               .degreesOfFreedom = 29}});
  EXPECT_EQ(cell(budget, 0, "sensitivity"), "0.50") << "mm per mm; below, mm per ″";
  EXPECT_EQ(cell(budget, 1, "sensitivity"), "0.030");
  EXPECT_EQ(cell(budget, 2, "sensitivity"), "") << "numbers of two sizes have no common one";
  EXPECT_EQ(cell(budget, 0, "type"), "B");
  EXPECT_EQ(cell(budget, 3, "type"), "A, 29") << "with its degrees of freedom";
  EXPECT_EQ(coverageWithFactor(2.0456, 0.95), "k = 2.05, 95 % coverage");
}

TEST(BudgetStatement, TellsTheReferenceOfAKnownSizeOnOneLine) {
  const Statement budget = stated({{.effect = "collimation",
                                    .from = UncertaintyShare::From::Known,
                                    .sigma = 1,
                                    .reference = "check\x1b 7"}});
  EXPECT_EQ(cell(budget, 0, "from"), "check\\u001b 7") << "as the session says it";
}

TEST(BudgetStatement, CombinesSharesBelowOnePercentOfTheVariance) {
  const UncertaintyShare little{.effect = "plane_warp", .sigma = 0.03},
      less{.effect = "arc_lobing", .sigma = 0.04},
      readings{.source = UncertaintySource::Readings, .sigma = 2};
  const Statement two = stated({readings, less, little});
  ASSERT_EQ(two.rows.size(), 4u);
  EXPECT_EQ(cell(two, 1, "source"), "2 others");
  EXPECT_EQ(cell(two, 1, "u"), "0.05") << "√(0.03² + 0.04²)";
  const Statement one = stated({readings, little});
  EXPECT_EQ(cell(one, 1, "source"), "plane warp") << "a single share keeps its name";
}

TEST(BudgetStatement, HasACellForEveryColumn) {
  const Measurement measurement = test::paperMeasurement();
  const SessionFit fit = fitSession(measurement);
  const auto diagnosis = diagnose(measurement, fit, {.withAttainable = true});
  ASSERT_TRUE(diagnosis);
  for (const Statement& budget : {measuredBudget(*diagnosis, 0.95), fitBudget(fit)}) {
    std::set<std::string> ids;
    for (const Statement::Column& column : budget.columns) ids.insert(column.id);
    EXPECT_EQ(ids.size(), budget.columns.size()) << budget.id;
    for (const Statement::Row& row : budget.rows) EXPECT_EQ(row.cells.size(), budget.columns.size());
    EXPECT_EQ(cell(budget, budget.rows.size() - 2, "share"), "100.0 %");
    for (const std::string& sentence : budget.sentences) EXPECT_TRUE(sentence.ends_with('.')) << sentence;
  }
}

TEST(BudgetStatement, CountsDegreesOfFreedomWhileThatTellsAnything) {
  EXPECT_EQ(degreesOfFreedomText(7.25), "7.2");
  EXPECT_EQ(degreesOfFreedomText(196.4), "196");
  EXPECT_EQ(degreesOfFreedomText(1e4), "10000");
  EXPECT_EQ(degreesOfFreedomText(269372), "many");
  EXPECT_EQ(degreesOfFreedomText(std::numeric_limits<double>::infinity()), "∞");
}

TEST(BudgetStatement, StatesNoShareOfNothing) {
  EXPECT_EQ(varianceShare(1, 2), "25.0 %");
  EXPECT_EQ(varianceShare(0, 0), "—");
}

}  // namespace
}  // namespace alidade
