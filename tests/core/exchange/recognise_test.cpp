#include "core/exchange/recognise.h"

#include <gmock/gmock.h>

#include "core/exchange/csv_reader.h"

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Recognised found(const std::string& text) {
  const Result<Recognised> recognised = recognise(text);
  EXPECT_TRUE(recognised) << text;
  return recognised ? *recognised : Recognised{};
}

TEST(Recognise, TellsTheFormatsByTheirLines) {
  EXPECT_EQ(found("# transferred\n110001+00000001 21.324+34152240 22.324+08816490\n").name, "Leica GSI");
  EXPECT_EQ(found("! made by\nFor M5|Adr 00001|TI  START |\n").name, "Trimble M5");
  EXPECT_EQ(found("00NMSDR33 V04-04.02     04-Oct-26 10:00 111111\n").name, "Sokkia SDR");
  EXPECT_FALSE(found("00NMSDR33 V04-04.02     04-Oct-26 10:00 111111\n").isTable());
  EXPECT_TRUE(found("\n\nHz;V\n1;2\n").isTable());
  EXPECT_FALSE(recognise("{\"format\": 1}"));
  EXPECT_FALSE(recognise(" \n# nothing\n"));
}

TEST(Recognise, SaysWhetherTheFileTellsTheAxis) {
  const std::string row = "110001+00000001 21.324+34152240 22.324+08816490\n";
  EXPECT_FALSE(found(row).saysAxis);
  EXPECT_TRUE(found("41....+00000180\n" + row).saysAxis);
  EXPECT_TRUE(found("axis,Hz,V\n0,1,2\n").saysAxis);
  EXPECT_FALSE(found("Hz,V\n1,2\n").saysAxis);
}

TEST(Recognise, FindsNamesBelowATitle) {
  const Recognised table =
      found("Arc 12, measured by R. Roe\nTheodolite;TM5100\n\nPt;Hz [gon];V [gon];Temp\n1;379,85;98,1;20\n");
  EXPECT_EQ(table.table.separator, ';');
  EXPECT_EQ(table.table.headRows, 3u);
  EXPECT_THAT(table.table.columns, ElementsAre("point", "horizontal", "vertical", ""));
  EXPECT_EQ(table.table.decimalSign, DecimalSign::Comma);
  EXPECT_FALSE(table.asksUnit) << "the names tell it";
}

TEST(Recognise, GuessesColumnsWithoutNames) {
  const Recognised table = found("1\t0\t341.5224\t88.1649\n2\t180\t341.2601\t86.4124\n");
  EXPECT_EQ(table.table.separator, '\t');
  EXPECT_EQ(table.table.headRows, 0u);
  EXPECT_THAT(table.table.columns, ElementsAre("point", "axis", "horizontal", "vertical"));
  EXPECT_TRUE(table.saysAxis);
  EXPECT_THAT(table.reasons, Contains(HasSubstr("guessed")));
}

TEST(Recognise, PartsByBlanksWhereCommasAreDecimalSigns) {
  const Recognised table = found("1   379,8592   98,0811\n2   379,9134   97,5400\n");
  EXPECT_EQ(table.table.separator, ' ');
  EXPECT_EQ(table.table.decimalSign, DecimalSign::Comma);
  EXPECT_THAT(table.table.columns, ElementsAre("point", "horizontal", "vertical"));
  const Recording recording = readTable("1   379,8592   98,0811\n2   379,9134   97,5400\n", table.table);
  ASSERT_EQ(recording.sightings.size(), 2u);
  EXPECT_EQ(recording.sightings[1].row.horizontal, "379,9134gon");
}

TEST(Recognise, ProposesAUnitWhereTheNumbersTellIt) {
  const auto unit = [](const std::string& rows) { return found("Hz,V\n" + rows).table.unit; };
  EXPECT_EQ(unit("379.8592,98.0811\n12.5,97.54\n"), AngleUnit::Gon);
  EXPECT_EQ(unit("12.5,101.8\n13.5,98.9\n"), AngleUnit::Gon) << "around the horizon of gon";
  EXPECT_EQ(unit("341.8733,88.2802\n341.4336,86.69\n"), AngleUnit::Degrees) << "87 are no minutes";
  EXPECT_EQ(unit("360.0000,88.2802\n341.4336,86.69\n"), AngleUnit::Degrees) << "a full turn by rounding";
  EXPECT_EQ(unit("341.5224,88.1649\n341.2601,86.4124\n"), AngleUnit::Unstated) << "either kind of degrees";
  EXPECT_EQ(unit("341°52'24\",88°16'49\"\n"), AngleUnit::Unstated);
  EXPECT_TRUE(found("Hz,V\n341.5224,88.1649\n").asksUnit);
  EXPECT_FALSE(found("Hz,V\n341°52'24\",88°16'49\"\n").asksUnit);
}

TEST(Recognise, KnowsFilesOfOneMakeByTheirNames) {
  const std::string a = found("Pt;Hz;V\n1;1.5;90.5\n").signature();
  EXPECT_EQ(a, found("Pt;Hz;V\n7;200.25;88.5\n8;201.25;89.5\n").signature());
  EXPECT_NE(a, found("Pt;V;Hz\n1;1.5;90.5\n").signature());
  EXPECT_NE(a, found("1;1.5;90.5\n").signature());
}

TEST(ReadTable, FollowsTheLayout) {
  TableLayout layout;
  layout.headRows = 0;
  layout.columns = {"vertical", "", "horizontal", "excluded"};
  layout.unit = AngleUnit::Dms;
  const Recording recording = readTable("88.1649,wind,341.5224,\n86.4124,,341.2601,yes\n", layout);
  EXPECT_THAT(recording.problems, IsEmpty());
  ASSERT_EQ(recording.sightings.size(), 2u);
  EXPECT_EQ(recording.sightings[0].line, 1u);
  EXPECT_EQ(recording.sightings[0].row.horizontal, "341 52 24");
  EXPECT_TRUE(recording.sightings[1].row.excluded);
  EXPECT_THAT(recording.unused, ElementsAre("the column 2 is not used: 1 value"));
}

TEST(ReadTable, RefusesTheOtherDecimalSign) {
  TableLayout layout;
  layout.decimalSign = DecimalSign::Point;
  const Recording recording = readTable("Hz;V\n341.5°;88.5°\n341,5°;88.5°\n", layout);
  EXPECT_EQ(recording.sightings.size(), 1u);
  ASSERT_EQ(recording.problems.size(), 1u);
  EXPECT_THAT(recording.problems[0].text(),
              HasSubstr("line 3, column 1: “341,5°” has a decimal sign other than"));
  layout.decimalSign = DecimalSign::Either;
  EXPECT_EQ(readTable("Hz;V\n341.5°;88.5°\n341,5°;88.5°\n", layout).sightings.size(), 2u);
}

TEST(ColumnNames, AreTextWithOneThatIsKnown) {
  EXPECT_TRUE(areColumnNames({"Point", "Hz [gon]", "whatever"}));
  EXPECT_FALSE(areColumnNames({"top", "left"}));
  EXPECT_FALSE(areColumnNames({"1", "Hz"}));
  EXPECT_FALSE(areColumnNames({"341 52 24", "V"}));
  EXPECT_FALSE(areColumnNames({}));
}

}  // namespace
}  // namespace alidade::test
