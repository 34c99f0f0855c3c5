#include <gmock/gmock.h>

#include "core/base/sha256.h"
#include "core/exchange/grouped_problems.h"
#include "core/exchange/import.h"
#include "core/session/measurement.h"
#include "tests/support/paper_table.h"

// Several files in one import, readings added to a session, and the recorded origins of rows.

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string first = "point,Hz,V\nzero,332°,90°\n1,341°,88°\n2,342°,88°\n",
                  second = "point,Hz,V\nzero,333°,90°\n1,341°,91°\n2,342°,91°\n";

Import imported(const std::vector<ReadingsFile>& files, const Session& base = blankSession()) {
  ImportOptions options;
  options.base = base;
  const Result<Import> import = importReadings(files, options);
  EXPECT_TRUE(import) << import.problem().text();
  return import ? *import : Import{};
}

std::string shapeOf(const Session& session) {
  std::string shape;
  for (const Position& position : session.positions) {
    shape += position.axisDeg + ":";
    for (const Reading& row : position.readings) shape += row.point + "/" + row.round + " ";
  }
  return shape;
}

TEST(SeveralFiles, GoToThePositionsThatAreStated) {
  const Import import = imported(
      {{.name = "a.csv", .bytes = first, .axis = "0"}, {.name = "b.csv", .bytes = second, .axis = "180"}});
  EXPECT_THAT(import.problems, IsEmpty());
  EXPECT_THAT(import.remarks, IsEmpty());
  EXPECT_THAT(import.unplaced, IsEmpty());
  EXPECT_EQ(shapeOf(import.session), "0:1/ 2/ 180:1/ 2/ ");
  EXPECT_EQ(import.session.positions[0].zero.horizontal, "332°");
  EXPECT_EQ(import.session.positions[1].zero.horizontal, "333°");
  EXPECT_EQ(import.format, "CSV");
}

TEST(SeveralFiles, AreRoundsWhereThatIsStatedAndWhereTheyRepeat) {
  const auto shape = [](const std::string& round) {
    return shapeOf(imported({{.name = "a", .bytes = first, .axis = "0"},
                             {.name = "b", .bytes = first, .axis = "0", .round = round}})
                       .session);
  };
  EXPECT_EQ(shape("3"), "0:1/1 2/1 1/3 2/3 ");
  EXPECT_EQ(shape(""), "0:1/1 2/1 1/2 2/2 ");
}

TEST(SeveralFiles, NameTheFileInWhatIsSaid) {
  const std::string odd = "point,Hz,V\n1,341°71',88°\n2,341°,88°\n";
  const Import import =
      imported({{.name = "a.csv", .bytes = first}, {.name = "b.csv", .bytes = odd, .axis = "180"}});
  ASSERT_EQ(import.problems.size(), 1u);
  EXPECT_THAT(import.problems[0].text(), HasSubstr("“b.csv”, line 2, column 3: horizontal"));
  EXPECT_THAT(import.remarks,
              Contains(HasSubstr("“a.csv”: the file does not state the position of the axis")));
  EXPECT_THAT(import.unplaced, ElementsAre(0u));
  ImportOptions options;
  const auto refused =
      importReadings({{.name = "a.csv", .bytes = first}, {.name = "none.csv", .bytes = "Hz,V\n"}}, options);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.problem().what, HasSubstr("“none.csv” holds no readings"));
}

TEST(SeveralFiles, RefuseTwoKindsOfVerticalCircle) {
  const auto refused = importReadings(
      {{.name = "a", .bytes = "Hz,zenith\n1°,88°\n"}, {.name = "b", .bytes = "Hz,elevation\n1°,2°\n"}},
      ImportOptions{});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.problem().what, HasSubstr("“b” has vertical readings of the kind elevation"));
}

TEST(AddedReadings, LeaveWhatIsThere) {
  const Session paper = paperSession();
  const Import import = imported({{.name = "a.csv", .bytes = first, .axis = "0"}}, paper);
  ASSERT_EQ(import.session.positions.size(), 3u) << "places sighted before: measured again";
  EXPECT_EQ(import.session.positions[0], paper.positions[0]);
  EXPECT_EQ(import.session.positions[1], paper.positions[1]);
  EXPECT_EQ(import.session.positions[2].readings.size(), 2u);
  EXPECT_EQ(import.session.positions[2].zero.horizontal, "332°");
  EXPECT_EQ(import.rows, 2u);
  EXPECT_EQ(import.session.geometry, paper.geometry);
}

TEST(AddedReadings, GoOnInAPositionWithOtherPlacesOrAnotherRound) {
  const Session paper = paperSession();
  const std::size_t rows = paper.positions[0].readings.size();
  const std::string others = "point,Hz,V\n101,341°,88°\n102,342°,88°\n";
  const Import more = imported({{.name = "a", .bytes = others, .axis = "0"}}, paper);
  ASSERT_EQ(more.session.positions.size(), 2u);
  EXPECT_EQ(more.session.positions[0].readings.size(), rows + 2);
  const Import round = imported({{.name = "a", .bytes = first, .axis = "180", .round = "2"}}, paper);
  ASSERT_EQ(round.session.positions.size(), 2u);
  EXPECT_EQ(round.session.positions[1].readings.back().round, "2");
  EXPECT_EQ(round.session.positions[1].zero, paper.positions[1].zero) << "as it was given";
  EXPECT_THAT(round.remarks, Contains(HasSubstr("the pointing zero at 180° keeps its given value")));
  for (const Problem& problem : examine(round.session).problems)
    EXPECT_THAT(problem.what, Not(HasSubstr("already"))) << "two readings in one place";
}

TEST(AddedReadings, FillAPositionThatStandsEmpty) {
  Session session = paperSession();
  session.positions.push_back({.axisDeg = "0", .zero = {}, .readings = {}, .origin = {}});
  const Import import = imported({{.name = "a", .bytes = first, .axis = "0"}}, session);
  ASSERT_EQ(import.session.positions.size(), 3u);
  EXPECT_EQ(import.session.positions[2].readings.size(), 2u);
}

TEST(AddedReadings, CountPointsWithNamesOnFromThoseThere) {
  Session session = blankSession();
  Reading row;
  row.point = "5";
  row.horizontal = "1°";
  row.vertical = "90°";
  session.positions[0].readings = {row};
  const Import import =
      imported({{.name = "a", .bytes = "point,Hz,V\ntop,1°,90°\nend,2°,90°\n", .axis = "0"}}, session);
  EXPECT_EQ(shapeOf(import.session), "0:5/ 6/ 7/ 180:");
}

TEST(Origins, TellFileAndLinesRowForRow) {
  const std::string gaps = "point,Hz,V\n1,341°,88°\n# wind\n2,342°,88°\n3,343°,88°\n";
  const Import import = imported(
      {{.name = "a.csv", .bytes = gaps, .axis = "0"}, {.name = "b.csv", .bytes = second, .axis = "180"}});
  ASSERT_EQ(import.origins.size(), 2u);
  EXPECT_EQ(linesText(import.origins[0]), "2, 4–5");
  EXPECT_EQ(linesText(import.origins[1]), "3–4");
  const auto entries = importEntries(import, {{"a.csv", sha256(gaps)}, {"b.csv", sha256(second)}});
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].place, "positions[0].readings");
  EXPECT_EQ(entries[0].why, "imported");
  EXPECT_EQ(entries[0].to, "“a.csv”, lines 2, 4–5: 3 rows from row 1 on; SHA-256 " + sha256(gaps));
  EXPECT_EQ(entries[1].axis, "180");
}

TEST(Origins, CountRowsBehindThoseThere) {
  const Import import =
      imported({{.name = "a", .bytes = first, .axis = "180", .round = "2"}}, paperSession());
  ASSERT_EQ(import.origins.size(), 1u);
  EXPECT_EQ(import.origins[0].position, 1u);
  EXPECT_EQ(import.origins[0].firstRow, 17u);
  EXPECT_EQ(import.origins[0].count, 2u);
}

// `printf abc | sha256sum`, and FIPS 180-4's empty message.
TEST(Sha256, IsThePublishedOne) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(GroupedProblems, AreOfOneKindWhateverWasRead) {
  const std::vector<ProblemGroup> groups = grouped({{2, 1, "horizontal “341.5” may mean 341.5° or 341°50′"},
                                                    {3, 1, "horizontal “1.25” may mean 1.25° or 1°25′"},
                                                    {3, 9, "vertical “x” is not an angle"},
                                                    {4, 1, "horizontal “2.5” may mean 2.5° or 2°50′"}});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].count, 3u);
  EXPECT_EQ(groups[0].text(),
            "line 2, column 1: horizontal “341.5” may mean 341.5° or 341°50′ (and 2 more of this kind)");
  EXPECT_EQ(groups[1].text(), "line 3, column 9: vertical “x” is not an angle");
  EXPECT_THAT(grouped({}), IsEmpty());
}

}  // namespace
}  // namespace alidade::test
