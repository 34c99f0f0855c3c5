#include "core/answers/csv_answers.h"

#include <gtest/gtest.h>

#include <map>

#include "core/diagnosis/diagnose.h"
#include "core/exchange/csv_table.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade::test {
namespace {

/// The rows of a table, with cells by column name.
std::vector<std::map<std::string, std::string>> rowsOf(const std::string& csv) {
  CsvTable table(csv);
  std::vector<std::string> names;
  std::vector<std::map<std::string, std::string>> rows;
  while (const auto row = table.next()) {
    if (names.empty()) {
      for (const CsvCell& cell : row->cells) names.push_back(cell.text);
      continue;
    }
    EXPECT_EQ(row->cells.size(), names.size());
    auto& cells = rows.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) cells[names[i]] = row->cells[i].text;
  }
  EXPECT_FALSE(table.problem());
  return rows;
}

// The first reading of Table I: 25.19″ with 2″ stated, r = 0.612, w = 2.33, 89.8″ detectable.
TEST(ResidualsCsv, HoldsEveryReadingOfThePaper) {
  const Measurement measurement = *examine(paperSession()).measurement;
  const auto rows = rowsOf(residualsCsv(measurement, fitSession(measurement)));
  ASSERT_EQ(rows.size(), 68u);
  const auto& first = rows.front();
  EXPECT_EQ(first.at("axis_deg"), "0");
  EXPECT_EQ(first.at("point"), "1");
  EXPECT_EQ(first.at("order"), "1");
  EXPECT_EQ(first.at("reading"), "horizontal");
  EXPECT_NEAR(std::stod(first.at("residual_arcsec")), 25.19, 0.01);
  EXPECT_NEAR(std::stod(first.at("sigma_arcsec")), 2, 1e-9);
  EXPECT_NEAR(std::stod(first.at("redundancy")), 0.612, 0.001);
  EXPECT_NEAR(std::stod(first.at("standardised_residual")), 2.33, 0.01);
  EXPECT_NEAR(std::stod(first.at("minimal_detectable_bias_arcsec")), 89.8, 0.1);
  EXPECT_NEAR(std::stod(first.at("s_deg")), 10.33, 0.01);
  EXPECT_EQ(rows.back().at("axis_deg"), "180");
  EXPECT_EQ(rows.back().at("reading"), "vertical");
  double squares = 0;
  for (const auto& row : rows) squares += std::pow(std::stod(row.at("residual_arcsec")) / 2, 2);
  EXPECT_NEAR(squares, fitSession(measurement).joint.chiSquare, 1e-6 * squares) << "χ² of the fit";
}

TEST(ResidualsCsv, HoldsSliderReadingsInTheOrderTaken) {
  const Result<Session> session = simulate(*protocolByName("full"), drawTruth(5), 5);
  ASSERT_TRUE(session);
  const Measurement measurement = *examine(*session).measurement;
  const SessionFit fit = fitSession(measurement);
  const auto rows = rowsOf(residualsCsv(measurement, fit));
  EXPECT_EQ(rows.size(), fit.joint.readings.size());
  int last = 0, sliders = 0, faceTwo = 0;
  for (const auto& row : rows) {
    EXPECT_GE(std::stoi(row.at("order")), last);
    last = std::stoi(row.at("order"));
    sliders += row.at("reading") == "slider" ? 1 : 0;
    faceTwo += row.at("face") == "2" ? 1 : 0;
  }
  EXPECT_GT(sliders, 0);
  EXPECT_GT(faceTwo, 0);
}

TEST(BudgetCsv, SharesOfEveryQuantityAddUpToOne) {
  const Measurement measurement = *examine(paperSession()).measurement;
  const SessionFit fit = fitSession(measurement);
  const auto found = diagnose(measurement, fit, {.withAttainable = true});
  ASSERT_TRUE(found && found->measured);
  std::map<std::string, double> shares, variances;
  for (const auto& row : rowsOf(budgetCsv(fit, &*found))) {
    const std::string of = row.at("quantity") + row.at("axis_deg");
    shares[of] += std::stod(row.at("share"));
    variances[of] += std::pow(std::stod(row.at("sigma_mm")), 2);
  }
  ASSERT_EQ(shares.size(), 8u) << "Δd twice, and three of each arc";
  for (const auto& [of, share] : shares) EXPECT_NEAR(share, 1, 1e-9) << of;
  EXPECT_NEAR(std::sqrt(variances["intersection_of_fit"]), fit.intersection->sigma, 1e-9);
  EXPECT_NEAR(std::sqrt(variances["intersection_as_measured"]), found->measured->estimate.sigma, 1e-9);
  EXPECT_NEAR(std::sqrt(variances["y180"]), fit.sigmas[1].y, 1e-9);
}

TEST(BudgetCsv, HasNoMeasuredQuantityWithoutADiagnosis) {
  const Measurement measurement = *examine(paperSession()).measurement;
  for (const auto& row : rowsOf(budgetCsv(fitSession(measurement), nullptr)))
    EXPECT_NE(row.at("quantity"), "intersection_as_measured");
}

}  // namespace
}  // namespace alidade::test
