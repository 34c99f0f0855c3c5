#include "core/exchange/import.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <random>

#include "core/adjustment/result/session_fit.h"
#include "core/session/session_file.h"
#include "tests/support/paper_table.h"

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string gsiOf(const std::string& name, const std::string& horizontal, const std::string& vertical) {
  return "110001+" + std::string(8 - name.size(), '0') + name + " 21.324+" + horizontal + " 22.324+" +
         vertical + "\n";
}

Import imported(const std::string& text, const ImportOptions& options = {},
                std::optional<std::size_t> turnedAtLine = {}) {
  const Result<Import> import =
      importReadings({{.name = {}, .bytes = text, .turnedAtLine = turnedAtLine}}, options);
  EXPECT_TRUE(import) << import.problem().text();
  return import ? *import : Import{};
}

std::string paperCsv() {
  std::ifstream file(std::string(ALIDADE_REFERENCE_DIR) + "/paper-table-1.csv");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The paper's statements outside its table.
ImportOptions paperOptions() {
  const Session paper = paperSession();
  ImportOptions options;
  options.base.geometry = paper.geometry;
  for (std::size_t i = 0; i < 2; ++i) options.base.positions[i].zero = paper.positions[i].zero;
  return options;
}

// The same texts give the same fit, to the last digit.
TEST(Import, PapersTableAsCsvFitsAsTheSampleDoes) {
  const Import import = imported(paperCsv(), paperOptions());
  EXPECT_EQ(import.rows, 34u);
  EXPECT_THAT(import.problems, IsEmpty());
  EXPECT_THAT(import.remarks, IsEmpty());
  const auto fit = fitSession(measurementOf(import.session));
  const auto sample = loadSession(ALIDADE_SAMPLES_DIR "/paper-table-1.alidade");
  ASSERT_TRUE(sample);
  const auto wanted = fitSession(measurementOf(*sample));
  ASSERT_TRUE(fit.intersection && wanted.intersection);
  EXPECT_EQ(fit.intersection->value, wanted.intersection->value);
}

TEST(Import, PapersTableAsGsiFitsTheSame) {
  const Session paper = paperSession();
  std::string gsi;
  const auto digits = [](std::string angle) {  // 341°52'24" as 34152240
    std::erase_if(angle, [](char c) { return c < '0' || c > '9'; });
    return std::string(7 - angle.size(), '0') + angle + "0";
  };
  for (const Position& position : paper.positions) {
    gsi += "41....+" + std::string(8 - position.axisDeg.size(), '0') + position.axisDeg + "\n";
    gsi += gsiOf("ZERO", digits(position.zero.horizontal), digits(position.zero.vertical));
    for (const Reading& reading : position.readings)
      gsi += gsiOf(reading.point, digits(reading.horizontal), digits(reading.vertical));
  }
  ImportOptions options;
  options.base.geometry = paper.geometry;
  const Import import = imported(gsi, options);
  EXPECT_THAT(import.remarks, IsEmpty());
  const auto fit = fitSession(measurementOf(import.session));
  const auto wanted = fitSession(measurementOf(paper));
  ASSERT_TRUE(fit.intersection && wanted.intersection);
  EXPECT_EQ(fit.intersection->value, wanted.intersection->value);
}

TEST(Import, TakesFacesAndRoundsFromWhatWasRead) {
  const Import import = imported(gsiOf("1", "34152240", "08816490") + gsiOf("1", "16152240", "27143110") +
                                 gsiOf("1", "34152240", "08816490"));
  ASSERT_EQ(import.session.positions.size(), 1u);
  const auto& readings = import.session.positions[0].readings;
  EXPECT_EQ(readings[0].face + readings[1].face + readings[2].face, "121");
  EXPECT_EQ(readings[0].round + readings[1].round + readings[2].round, "112");
  EXPECT_THAT(import.remarks, Contains(HasSubstr("further rounds")));
  EXPECT_THAT(import.remarks, Contains(HasSubstr("assigned to 0°")));
}

TEST(Import, LeavesFaceAndRoundEmptyWhereThereIsOne) {
  const Import import = imported(gsiOf("1", "34152240", "08816490") + gsiOf("2", "34152240", "08816490"));
  EXPECT_EQ(import.session.positions.at(0).readings.at(0).face, "");
  EXPECT_EQ(import.session.positions.at(0).readings.at(0).round, "");
}

TEST(Import, TellsPositionsByTheLineWhereTheFileDoesNot) {
  const Import import =
      imported(gsiOf("1", "34152240", "08816490") + gsiOf("1", "34152240", "08816490"), {}, 2);
  ASSERT_EQ(import.session.positions.size(), 2u);
  EXPECT_EQ(import.session.positions[1].axisDeg, "180");
  EXPECT_EQ(import.session.positions[1].readings.size(), 1u);
  EXPECT_THAT(import.remarks, IsEmpty());
}

TEST(Import, RefusesALineBehindTheLastReading) {
  const std::string gsi = gsiOf("1", "34152240", "08816490") + gsiOf("1", "34152240", "08816490") + "\n\n";
  const auto import = importReadings({{.name = {}, .bytes = gsi, .turnedAtLine = 3}});
  ASSERT_FALSE(import);
  EXPECT_THAT(import.problem().what, HasSubstr("its last reading in line 2"));
}

// Readings of one point, face and round are one visit: two different visits must not become one.
TEST(Import, PassesOverRoundsThatTheFileStates) {
  const auto roundsOf = [](const std::string& rows) {
    std::string rounds;
    const Import import = imported("axis,point,round,face,Hz,V\n" + rows);
    for (const Reading& reading : import.session.positions.at(0).readings) rounds += reading.round;
    for (const Problem& problem : examine(import.session).problems)
      EXPECT_THAT(problem.what, Not(HasSubstr("already"))) << "two readings in one place";
    return rounds;
  };
  EXPECT_EQ(roundsOf("0,1,,,341°,88°\n0,1,,,341°,88°\n0,1,2,,341°,88°\n"), "132");
  EXPECT_EQ(roundsOf("0,1,1,,341°,88°\n0,2,,,341°,88°\n0,1,,,341°,88°\n"), "112");
  EXPECT_EQ(roundsOf("0,1,1,1,341°,88°\n0,1,,2,161°,272°\n0,01,,,341°,88°\n"), "112") << "by face";
  EXPECT_EQ(roundsOf("0,1,1,,341°,88°\n0.0,1,,,341°,88°\n"), "12") << "0.0 is 0";
}

TEST(Import, PutsThePositionsInTheOrderOfASession) {
  const Import import = imported("axis,Hz,V\n180,341°,88°\n0,341°,87°\n");
  EXPECT_EQ(import.session.positions.at(0).axisDeg, "0");
  EXPECT_EQ(import.session.positions.at(0).readings.at(0).vertical, "87°");
  EXPECT_EQ(import.session.positions.at(1).axisDeg, "180");
  EXPECT_THAT(import.remarks, ElementsAre(HasSubstr("180° was read before 0°")));
  EXPECT_THAT(imported("axis,Hz,V\n0,341°,88°\n180,341°,88°\n0,341°,87°\n").remarks,
              Contains(HasSubstr("alternate")));
}

std::string axesOf(const Import& import) {
  std::string axes;
  for (const Position& position : import.session.positions)
    axes += position.axisDeg + "°:" + std::to_string(position.readings.size()) + " ";
  return axes;
}

// Places that are sighted again after the axis returned belong to another position, together with the zeros
// sighted at that time. Further rounds and new places do not.
TEST(Import, MakesAPositionOfEachTimeTheAxisComesBack) {
  const auto of = [](const std::string& rows) { return imported("axis,point,round,face,Hz,V\n" + rows); };
  const std::string first = "0,1,,,341°,88°\n0,2,,,342°,88°\n",
                    other = "180,1,,,341°,91°\n180,2,,,342°,91°\n",
                    again = "0,1,,,341°,87°\n0,2,,,342°,87°\n";
  const Import thrice = of(first + other + again);
  EXPECT_EQ(axesOf(thrice), "0°:2 180°:2 0°:2 ");
  EXPECT_EQ(thrice.session.positions.at(2).readings.at(0).vertical, "87°");
  EXPECT_EQ(thrice.session.positions.at(2).readings.at(0).round, "");
  EXPECT_THAT(thrice.remarks, IsEmpty());
  EXPECT_EQ(axesOf(of(other + first + other)), "180°:2 0°:2 180°:2 ") << "in the order of the file";
  EXPECT_EQ(axesOf(of(first + other + again + other)), "0°:2 180°:2 0°:2 180°:2 ");
  const Import rounds = of(first + other + "0,1,2,,341°,87°\n");
  EXPECT_EQ(axesOf(rounds), "0°:3 180°:2 ");
  EXPECT_THAT(rounds.remarks, Contains(HasSubstr("alternate")));
  EXPECT_EQ(axesOf(of("0,1,,,341°,88°\n180,1,,,341°,91°\n0,2,,,341°,88°\n180,2,,,341°,91°\n")),
            "0°:2 180°:2 ")
      << "sorted by points";
  EXPECT_EQ(axesOf(of("180,1,,,341°,91°\n0,1,,,341°,88°\n180,2,,,341°,91°\n")), "0°:1 180°:2 ");
}

TEST(Import, TakesTheZerosOfAPositionMeasuredAgain) {
  const auto row = [](const std::string& axis, const std::string& name, const std::string& horizontal) {
    return axis + "," + name + "," + horizontal + ",89°\n";
  };
  const Import import = imported("axis,point,Hz,V\n" + row("0", "zero", "332°") + row("0", "1", "341°") +
                                 row("180", "zero", "333°") + row("180", "1", "341°") +
                                 row("0", "zero", "334°") + row("0", "1", "341°"));
  ASSERT_EQ(import.session.positions.size(), 3u);
  EXPECT_EQ(import.session.positions[0].zero.horizontal, "332°");
  EXPECT_EQ(import.session.positions[1].zero.horizontal, "333°");
  EXPECT_EQ(import.session.positions[2].zero.horizontal, "334°");
  EXPECT_EQ(import.session.positions[2].readings.size(), 1u);
}

TEST(Import, ListsReadingsThatWereTurnedIntoRemarks) {
  const auto remarks = [](const std::string& line) {
    return imported("axis,point,Hz [gon],V\n0,1,379.8,98.1gon\n" + line + "\n").remarks;
  };
  EXPECT_THAT(remarks("#0,2,379.9,98.2gon"),
              ElementsAre("line 3 begins with # and is not used, though it holds a reading"));
  EXPECT_THAT(remarks("# 0,2,,98.2gon"), IsEmpty()) << "one circle is no reading";
  EXPECT_THAT(remarks("# wind from the left, 3 m/s, see page 2, 15°"), IsEmpty());
}

// A zero has a place for each face, before and after the readings, so that a move of the instrument shows.
TEST(Import, KeepsSightingsOfAZeroApartByFaceAndTime) {
  const Import import = imported(gsiOf("0", "33232500", "08959580") + gsiOf("1", "34152240", "08816490") +
                                 gsiOf("0", "15232540", "27000060"));
  const PointingZero& zero = import.session.positions.at(0).zero;
  EXPECT_EQ(zero.horizontal, "332°32'50.0\"");
  EXPECT_EQ(zero.vertical, "89°59'58.0\"");
  EXPECT_EQ(zero.afterInTwo.horizontal, "152°32'54.0\"");
  EXPECT_EQ(zero.afterInTwo.vertical, "270°00'06.0\"");
  EXPECT_THAT(import.remarks, Not(Contains(HasSubstr("is the mean of"))));
  EXPECT_EQ(import.rows, 1u);
}

// Two set-ups in one file, or a reading a degree off, are no mean of anything.
TEST(Import, RefusesSightingsOfAZeroThatAreFarApart) {
  for (const char* horizontal : {"33332500", "01232540"}) {
    const Import import = imported(gsiOf("0", "33232500", "08959580") + gsiOf("0", horizontal, "08959580") +
                                   gsiOf("1", "34152240", "08816490"));
    ASSERT_EQ(import.problems.size(), 1U);
    EXPECT_EQ(import.problems[0].line, 2U);
    EXPECT_THAT(import.problems[0].what, HasSubstr("from the first sighting of the pointing zero"));
  }
}

// 359°59'59" and 0°00'01" are 2″ apart, not 360°.
TEST(Import, AveragesAcrossTheZeroOfTheCircle) {
  const Import import = imported(gsiOf("0", "35959590", "09000000") + gsiOf("0", "00000030", "09000000") +
                                 gsiOf("1", "00852240", "08816490"));
  EXPECT_EQ(import.session.positions.at(0).zero.horizontal, "0°00'01.00\"");
}

TEST(Import, FindsTheZeroByItsNameOrRefusesTheName) {
  const std::string text = gsiOf("7", "33232500", "08959580") + gsiOf("8", "34152240", "08816490");
  ImportOptions options;
  options.zeroPoint = "0007";
  EXPECT_EQ(imported(text, options).rows, 1U);
  EXPECT_EQ(imported(text, options).missingZeroPoint, "");
  options.zeroPoint = "K9";
  EXPECT_THAT(imported(text, options).missingZeroPoint, HasSubstr("no sighting is named “K9”"));
}

TEST(Import, KeepsAZeroThatWasGiven) {
  ImportOptions options;
  options.base.positions[0].zero = {"332°", "90°", {}};
  const Import import =
      imported(gsiOf("0", "33232500", "08959580") + gsiOf("1", "34152240", "08816490"), options);
  EXPECT_EQ(import.session.positions.at(0).zero.horizontal, "332°");
  EXPECT_THAT(import.remarks, Contains(HasSubstr("the sighting in line 1 is not used")));
}

TEST(Import, NumbersPointsWithNamesInEachPosition) {
  const Import import =
      imported("axis,point,Hz,V,note\n0,top,341°,88°,wind\n0,end,341°,87°,\n180,end,341°,88°,\n");
  const Reading& top = import.session.positions.at(0).readings.at(0);
  EXPECT_EQ(top.point, "1");
  EXPECT_EQ(top.note, "top: wind");
  EXPECT_EQ(import.session.positions.at(1).readings.at(0).point, "1");
}

TEST(Import, NamesEntriesByLineAndColumnAndKeepsThem) {
  const Import import = imported("axis,point,Hz,V,face\n0,1,341.5224,88°71'49\",3\n90,2,341°,88°,1\n");
  ASSERT_EQ(import.problems.size(), 4u);
  EXPECT_THAT(import.problems[0].text(), HasSubstr("line 2, column 5: horizontal “341.5224” may mean"));
  EXPECT_THAT(import.problems[1].text(),
              HasSubstr("line 2, column 14: vertical “88°71'49\"” has 71 minutes"));
  EXPECT_THAT(import.problems[2].text(), HasSubstr("line 2, column 24: face “3”"));
  EXPECT_THAT(import.problems[3].text(), HasSubstr("line 3, column 1: axis “90”"));
  EXPECT_EQ(import.session.positions.at(0).readings.at(0).vertical, "88°71'49\"");
  for (std::size_t i = 0; i < import.problems.size(); ++i)
    EXPECT_EQ(import.problems[i].asksUnit, i == 0) << import.problems[i].text();
}

TEST(Import, RefusesWhatHoldsNoReadings) {
  const auto refusal = [](const std::string& text) {
    const Result<Import> import = importReadings({{.name = {}, .bytes = text}});
    EXPECT_FALSE(import) << text;
    return import ? std::string() : import.problem().what;
  };
  EXPECT_THAT(refusal(""), HasSubstr("holds no readings"));
  EXPECT_THAT(refusal("# nothing\n"), HasSubstr("holds no readings"));
  EXPECT_THAT(refusal("{\"format\": \"alidade-session\"}"), HasSubstr("session"));
  EXPECT_THAT(refusal("Hz,V\n"), HasSubstr("holds no readings"));
  EXPECT_THAT(refusal("41....+00000180\n"), HasSubstr("holds no readings"));
  EXPECT_THAT(refusal("a,b\n1,2\n"), HasSubstr("line 1"));
}

/// The conditions on every import: a session that can be written and read, a sentence and a line for every
/// problem.
void expectSound(const std::string& text) {
  const Result<Import> import = importReadings({{.name = {}, .bytes = text}});
  if (!import) {
    EXPECT_FALSE(import.problem().what.empty());
    return;
  }
  for (const LineProblem& problem : import->problems) {
    EXPECT_GT(problem.line, 0u);
    EXPECT_FALSE(problem.what.empty());
  }
  const Result<Session> again = readSession(writeSession(import->session));
  ASSERT_TRUE(again) << again.problem().text() << "\n" << text;
  EXPECT_EQ(writeSession(*again), writeSession(import->session)) << text;
}

// 6000 files, each with up to eight bytes of a valid one changed, removed or doubled.
TEST(Import, SurvivesDamagedFiles) {
  std::mt19937 random(20180101);
  const auto below = [&random](std::size_t count) { return random() % count; };
  const std::string signs = "0179+-*.,;\t\n\r\"' °#@\x80\xFF\xC2ZA";
  const std::string gsi = gsiOf("0", "33232500", "08959580") + "41....+00000180\n" +
                          gsiOf("A1", "34152240", "08816490") +
                          "*110001+0000000000000001 31..00+0000000000002405\n";
  const std::string m5 =
      "For M5|Adr 00003|TI  AXIS 180                   |22             16      |\r\n"
      "For M5|Adr 00004|PI1                           2|SD          7.674 m   |Hz         7.5439 DMS |V1     "
      "   "
      "89.1413 DMS | \r\n";
  const std::string sdr =
      "00NMSDR33 V04-04.02 000004-Oct-26 10:00 211111\r\n13NMAXIS 180\r\n09F1ST1             101             "
      "63.2140         101.23450000    87.43210000     SLIDE           \r\n";
  for (const std::string& whole : {gsi, paperCsv().substr(0, 300), m5, sdr}) {
    for (int i = 0; i < 1500; ++i) {
      std::string text = whole;
      for (std::size_t change = 1 + below(8); change > 0 && !text.empty(); --change) {
        const std::size_t at = below(text.size());
        switch (below(4)) {
          case 0:
            text.erase(at, 1 + below(4));
            break;
          case 1:
            text.insert(at, 1, signs[below(signs.size())]);
            break;
          case 2:
            text.insert(at, text.substr(at, below(20)));
            break;
          default:
            text[at] = signs[below(signs.size())];
        }
      }
      expectSound(text);
    }
  }
}

TEST(Import, ReadsLongFilesAndLongLines) {
  std::string text = "point,Hz,V\n";
  for (int i = 0; i < 20000; ++i) text += std::to_string(i) + ",341°52'24\",88°16'49\"\n";
  EXPECT_EQ(imported(text).rows, 20000u);
  expectSound("Hz,V\n" + std::string(200000, ','));
  expectSound("Hz,V\n" + std::string(200000, '"'));
  std::string block = "110001+00000001";
  for (int i = 0; i < 10000; ++i) block += " 31..00+00002405";
  expectSound(block);
}

}  // namespace
}  // namespace alidade::test
