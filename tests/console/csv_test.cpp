#include <gmock/gmock.h>

#include <map>

#include "core/exchange/csv_table.h"
#include "tests/console/console.h"

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::vector<std::string>> rowsOf(const std::string& text) {
  CsvTable table(text);
  std::vector<std::vector<std::string>> rows;
  while (const auto row = table.next()) {
    auto& cells = rows.emplace_back();
    for (const CsvCell& cell : row->cells) cells.push_back(cell.text);
  }
  return rows;
}

std::vector<std::vector<std::string>> tableOf(const std::string& kind) {
  const ProgramRun run = alidadeCli({"fit", paperSession, "--csv", kind});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  return rowsOf(run.out);
}

TEST(FitCsv, HoldsTheNumbersOfTheDocument) {
  const Json fit = Json::parse(alidadeCli({"fit", paperSession, "--json"}).out);
  std::map<std::string, std::vector<std::string>> rows;
  for (const auto& row : tableOf("results")) rows[row[0] + row[1]] = row;
  EXPECT_EQ(rows.at("quantityaxis_deg"),
            (std::vector<std::string>{"quantity", "axis_deg", "turn", "unit", "value", "sigma", "expanded",
                                      "coverage"}));
  const auto expectRow = [&](const std::string& name, const Json& value, const Json& sigma,
                             const Json& expanded) {
    const auto& row = rows.at(name);
    EXPECT_EQ(std::stod(row[4]), value.get<double>()) << name;
    if (!sigma.is_null()) {
      EXPECT_EQ(std::stod(row[5]), sigma.get<double>()) << name;
    }
    if (expanded.is_null()) {
      EXPECT_EQ(row[6] + row[7], "") << name;
    } else {
      EXPECT_EQ(std::stod(row[6]), expanded.get<double>()) << name;
      EXPECT_EQ(row[7], "0.95") << name;
    }
  };
  const auto expectLength = [&](const std::string& name, const Json& length) {
    expectRow(name, length["value_mm"], length["sigma_mm"], length["expanded_mm"]);
  };
  expectLength("intersection_as_measured", fit["intersection_as_found"]);
  expectLength("intersection_of_fit", fit["intersection"]);
  expectLength("across_plane", fit["across_plane"]);
  expectLength("distance_from_axis", fit["distance_from_axis"]);
  for (const Json& arc : fit["arcs"]) {
    const std::string axis = std::to_string(arc["axis_deg"].get<int>());
    expectRow("x" + axis, arc["center_mm"]["x"], arc["sigma_mm"]["x"], {});
    expectRow("y" + axis, arc["center_mm"]["y"], arc["sigma_mm"]["y"], {});
    expectRow("radius" + axis, arc["radius_mm"], arc["sigma_mm"]["radius"], {});
    for (const auto& [quantity, key] : {std::pair("sightings", "readings"),
                                        {"residual_rms", "residual_rms_arcsec"},
                                        {"reduced_chi_square", "reduced_chi2"},
                                        {"redundancy", "degrees_of_freedom"}})
      expectRow(quantity + axis, arc[key], {}, {});
  }
  EXPECT_EQ(rows.size(), 20u) << "five of the session, seven of each arc, and the names";
}

TEST(FitCsv, IsATableOfEachKind) {
  EXPECT_EQ(tableOf("residuals").size(), 69u) << "34 rows of two readings, and the names";
  EXPECT_THAT(tableOf("residuals")[0], ::testing::Contains("residual_arcsec"));
  EXPECT_THAT(tableOf("budget")[0], ::testing::Contains("sigma_mm"));
  EXPECT_GT(tableOf("budget").size(), 8u);
}

// Rows are in the order of the files, whatever characters the file names contain.
TEST(FitCsv, IsOneTableOfTheResultsOfManyFiles) {
  const TemporaryFolder folder;
  const auto same = [](Json&) {};
  const std::string first = folder.file("b, \"1\".alidade", changedPaperSession(same)),
                    second = folder.file("a.alidade", changedPaperSession(same));
  const ProgramRun run =
      alidadeCli({"fit", first, folder.path() / "none.alidade", second, "--csv", "results"});
  EXPECT_EQ(run.exitCode, 2) << "one is not there";
  const auto rows = rowsOf(run.out);
  const auto alone = tableOf("results");
  ASSERT_EQ(rows.size(), 2 * alone.size() - 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<std::string> row = alone[i < alone.size() ? i : i - alone.size() + 1];
    row.insert(row.begin(), i == 0 ? "file" : i < alone.size() ? first : second);
    EXPECT_EQ(rows[i], row);
  }
}

TEST(FitCsv, GoesWithNoOtherAnswer) {
  expectRefusal(alidadeCli({"fit", paperSession, "--csv", "results", "--json"}));
  expectRefusal(alidadeCli({"fit", paperSession, "--csv", "results", "--method", "published"}));
  expectRefusal(alidadeCli({"fit", paperSession, "--csv", "everything"}));
  EXPECT_EQ(alidadeCli({"fit", paperSession, paperSession + "x", "--csv", "budget"}).exitCode, 2);
}

}  // namespace
}  // namespace alidade::test
