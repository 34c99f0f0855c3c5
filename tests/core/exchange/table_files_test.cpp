#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "core/base/angle_text.h"
#include "core/exchange/csv_reader.h"
#include "core/exchange/import.h"

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string tableFile(const std::string& name) {
  std::ifstream file(std::string(ALIDADE_REFERENCE_DIR) + "/import/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_FALSE(text.str().empty()) << name;
  return text.str();
}

Import importOf(const std::string& name, AngleUnit unit = AngleUnit::Unstated) {
  ImportOptions options;
  options.unit = unit;
  const std::string bytes = tableFile(name);
  const Result<Import> import = importReadings({{.name = {}, .bytes = bytes}}, options);
  EXPECT_TRUE(import) << name << ": " << (import ? "" : import.problem().what);
  return import ? *import : Import{};
}

/// The circles of a row, in degrees.
std::pair<double, double> circlesOf(const Reading& row) {
  const auto horizontal = parseAngle(row.horizontal), vertical = parseAngle(row.vertical);
  EXPECT_TRUE(horizontal && vertical) << row.horizontal << " " << row.vertical;
  return {horizontal ? horizontal->degrees() : -1, vertical ? vertical->degrees() : -1};
}

void expectCircles(const Reading& row, const std::string& horizontal, const std::string& vertical) {
  constexpr double rounding = 1e-12;  // of a double of degrees
  const auto [h, v] = circlesOf(row);
  EXPECT_NEAR(h, parseAngle(horizontal)->degrees(), rounding);
  EXPECT_NEAR(v, parseAngle(vertical)->degrees(), rounding);
}

const std::vector<Reading>& rowsOf(const Import& import) {
  EXPECT_THAT(import.problems, IsEmpty());
  return import.session.positions.at(0).readings;
}

TEST(TableFiles, JoinDegreesMinutesAndSeconds) {
  const Import import = importOf("01-dms-columns.csv");
  const auto& rows = rowsOf(import);
  ASSERT_EQ(rows.size(), 3U);
  expectCircles(rows[0], "17°41'33\"", "86°12'07\"");
  expectCircles(rows[1], "18°02'51\"", "86°44'30\"");
  expectCircles(rows[2], "18°30'09\"", "87°20'58\"");
}

TEST(TableFiles, TakeSForADistance) {
  const Import import = importOf("16-table-s-is-distance.csv", AngleUnit::Gon);
  ASSERT_EQ(rowsOf(import).size(), 3U);
  expectCircles(rowsOf(import)[0], "219.1234gon", "98.2345gon");
  EXPECT_EQ(rowsOf(import)[0].slider, "");
  EXPECT_THAT(import.remarks, Contains(HasSubstr("the column “S” is not used: 3 values")));
}

TEST(TableFiles, ReadBlanksBelowNames) {
  const Import import = importOf("17-blank-table-with-names.txt");
  ASSERT_EQ(rowsOf(import).size(), 3U);
  expectCircles(rowsOf(import)[2], "108.9903°", "89.0197°");
}

TEST(TableFiles, PassOverMeans) {
  const Import import = importOf("18-table-mean-row.csv");
  EXPECT_EQ(rowsOf(import).size(), 3U);
  EXPECT_THAT(import.remarks, Contains(HasSubstr("means or sums are not used: line 5")));
}

TEST(TableFiles, KnowPointsAndFaces) {
  for (const char* name : {"19-table-german.csv", "20-table-faces-fl-fr.csv"}) {
    const Import import = importOf(name);
    std::vector<std::string> faces;
    for (const Reading& row : rowsOf(import)) faces.push_back(row.point + "/" + row.face);
    if (std::string(name).starts_with("19"))
      EXPECT_THAT(faces, ElementsAre("1/1", "2/1", "2/2", "1/2"));
    else
      EXPECT_THAT(faces, ElementsAre("1/1", "1/2"));
  }
}

TEST(TableFiles, ReadUnitsBelowNamesAndSignsOfKeyboards) {
  expectCircles(rowsOf(importOf("23-table-units-row.csv")).at(0), "219.1234gon", "98.2345gon");
  EXPECT_EQ(rowsOf(importOf("23-table-units-row.csv")).size(), 2U);
  for (const char* name : {"24-table-acute-accents.csv", "25-table-ring-from-pdf.csv"})
    expectCircles(rowsOf(importOf(name)).at(0), "107°12'23\"", "88°47'31\"");
}

TEST(TableFiles, SayWhatCanOnlyBeGon) {
  const Import import = importOf("27-table-plain-numbers.csv");
  ASSERT_FALSE(import.problems.empty());
  EXPECT_THAT(import.problems[0].text(), HasSubstr("“379.1234” can only be gon"));
  EXPECT_THAT(import.problems[0].text(), HasSubstr("--unit gon"));
  expectCircles(rowsOf(importOf("27-table-plain-numbers.csv", AngleUnit::Gon)).at(0), "379.1234gon",
                "98.2345gon");
}

TEST(TableFiles, DeliverWhatACheckNeeds) {
  TableLayout layout;
  layout.needsVertical = false;
  const Recording directions = readTable(tableFile("28-check-directions-only.csv"), layout);
  EXPECT_THAT(directions.problems, IsEmpty());
  ASSERT_EQ(directions.sightings.size(), 8U);
  EXPECT_EQ(directions.sightings[2].row.face, "2");
  EXPECT_EQ(directions.sightings[2].row.vertical, "");
  EXPECT_FALSE(readTable(tableFile("28-check-directions-only.csv"), {}).problems.empty());

  const Recording faces = readTable(tableFile("29-check-faces-side-by-side.csv"), {});
  EXPECT_THAT(faces.problems, IsEmpty());
  ASSERT_EQ(faces.sightings.size(), 8U);
  EXPECT_EQ(faces.sightings[1].row.point, "P");
  EXPECT_EQ(faces.sightings[1].row.face, "2");
  EXPECT_EQ(faces.sightings[1].row.horizontal, "210.0012gon");
  EXPECT_EQ(faces.sightings[1].row.vertical, "301.0004gon");
  EXPECT_EQ(faces.sightings[1].line, faces.sightings[0].line);
}

}  // namespace
}  // namespace alidade::test
