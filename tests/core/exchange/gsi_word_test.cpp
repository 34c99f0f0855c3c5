#include "core/exchange/gsi_word.h"

#include <gmock/gmock.h>

#include <map>
#include <string>

#include "core/base/angle_text.h"

// The words are from the data format chapter of the TPS1100 user manual, and so are the values if the chapter
// states them.

namespace alidade::test {
namespace {

using ::testing::HasSubstr;

std::vector<GsiWord> wordsOf(std::string_view text) {
  const auto words = gsiWords({1, text});
  EXPECT_TRUE(std::holds_alternative<std::vector<GsiWord>>(words)) << text;
  return std::get<std::vector<GsiWord>>(words);
}

LineProblem problemOf(std::string_view text) {
  const auto words = gsiWords({7, text});
  EXPECT_TRUE(std::holds_alternative<LineProblem>(words)) << text;
  return std::get<LineProblem>(words);
}

std::string angleOf(std::string_view text) {
  return std::get<std::string>(gsiAngle(wordsOf(text).at(0), 1));
}

std::string refusalOf(std::string_view text) {
  const LineProblem problem = std::get<LineProblem>(gsiAngle(wordsOf(text).at(0), 7));
  EXPECT_EQ(problem.line, 7u);
  return problem.what;
}

TEST(GsiWord, TakesABlockOfEightApart) {
  const auto words = wordsOf("110002+0000A110 21.102+17920860 22.104-08816490 51..1.+0000+000");
  ASSERT_EQ(words.size(), 4u);
  EXPECT_EQ(words[0].index, 11);
  EXPECT_EQ(gsiText(words[0]), "A110");
  EXPECT_EQ(words[1].index, 21);
  EXPECT_EQ(words[1].unit, '2');
  EXPECT_EQ(words[1].column, 17u);
  EXPECT_EQ(words[2].sign, '-');
  EXPECT_EQ(words[3].data, "0000+000");
}

TEST(GsiWord, TakesABlockOfSixteenApart) {
  const auto words = wordsOf("*110002+00000000PNC00055 21.024+0000000003545100 51....+000000000017+000 ");
  ASSERT_EQ(words.size(), 3u);
  EXPECT_EQ(gsiText(words[0]), "PNC00055");
  EXPECT_EQ(words[1].column, 26u);
  EXPECT_EQ(words[1].data, "0000000003545100");
  // Some programs leave the asterisk out.
  EXPECT_EQ(wordsOf("110002+00000000PNC00055 21.024+0000000003545100")[1].data, "0000000003545100");
}

TEST(GsiWord, KeepsBlanksInsideAName) {
  const auto words = wordsOf("110001+000NO 12 22.102+07567500");
  ASSERT_EQ(words.size(), 2u);
  EXPECT_EQ(gsiText(words[0]), "NO 12");
}

TEST(GsiWord, ReadsEveryUnitOfAnAngle) {
  EXPECT_EQ(angleOf("21.102+17920860"), "179.20860gon");
  EXPECT_EQ(angleOf("22.103+12345670"), "123.45670°");
  EXPECT_EQ(angleOf("22.104+12345120"), "123°45'12.0\"");
  EXPECT_EQ(angleOf("22.104+00000005"), "0°00'00.5\"");
  EXPECT_EQ(angleOf("22.102-00500000"), "-5.00000gon");
  EXPECT_EQ(angleOf("*21.024+0000000035959599"), "359°59'59.9\"");
  // 1234.5670 mil of 6400 to a turn.
  EXPECT_EQ(angleOf("22.105+12345670"), "69.444393750°");
  EXPECT_DOUBLE_EQ(parseAngle(angleOf("22.105+16000000"))->degrees(), 90);
}

// 160 mil of 6400 to a turn are 9°.
TEST(GsiWord, KeepsTheSignInEveryUnit) {
  EXPECT_EQ(angleOf("22.102-00500000"), "-5.00000gon");
  EXPECT_EQ(angleOf("22.103-00500000"), "-5.00000°");
  EXPECT_EQ(angleOf("22.104-00500000"), "-5°00'00.0\"");
  EXPECT_EQ(angleOf("22.105-01600000"), "-9.000000000°");
}

TEST(GsiWord, RefusesWhatIsNoAngle) {
  EXPECT_THAT(refusalOf("21.100+17920860"), HasSubstr("character 6"));
  EXPECT_THAT(refusalOf("21.10.+17920860"), HasSubstr("character 6"));
  EXPECT_THAT(refusalOf("21.102+1792 860"), HasSubstr("digits"));
  EXPECT_THAT(refusalOf("*21.102+1234567890123456"), HasSubstr("larger than a full circle"));
}

// Minutes beyond 59 are passed on unchanged; the rules of entries report them.
TEST(GsiWord, LeavesRangesToTheRulesOfEntries) {
  EXPECT_EQ(angleOf("22.104+08875000"), "88°75'00.0\"");
  EXPECT_FALSE(parseAngle(angleOf("22.104+08875000")));
}

TEST(GsiWord, NamesWhereABlockIsBroken) {
  EXPECT_EQ(problemOf("110002+00000001 21.102+179208").column, 17u);
  EXPECT_THAT(problemOf("110002+00000001 21.102+179208").what, HasSubstr("neither 8 nor 16"));
  EXPECT_THAT(problemOf("*110002+00000001").what, HasSubstr("starts with *"));
  EXPECT_EQ(problemOf("110002+00000001 hello").column, 17u);
  EXPECT_THAT(problemOf("11000200000001").what, HasSubstr("no GSI word"));
  EXPECT_EQ(problemOf("*").line, 7u) << "a star alone";
}

// The names are BÖDEN1Ä, 点位7 and ÄB: a program counts characters of the file, which were bytes.
TEST(GsiWord, CountsWidthsInCharactersOfTheFile) {
  const std::string circle = " 21.322+0000000011912345";
  for (const std::string name :
       {"000000000BÖDEN1Ä", "00000000BÖDEN1Ä", "0000000BÖDEN1Ä", "00000000000点位7", "0000000000000点位7"}) {
    std::string line = "*110001+";
    line += name;
    const auto words = gsiWords({1, line + circle});
    const bool isWhole = std::holds_alternative<std::vector<GsiWord>>(words);
    EXPECT_EQ(isWhole, name != "00000000BÖDEN1Ä") << name;
  }
  EXPECT_EQ(gsiText(wordsOf("110001+00000ÄB7 21.102+11912345")[0]), "ÄB7");
  EXPECT_EQ(gsiText(wordsOf("110001+000ÄB  7 21.102+11912345")[0]), "ÄB  7");
}

TEST(GsiWord, ReadsAFullTurnAsZero) {
  EXPECT_EQ(angleOf("21.102+40000000"), "0.00000gon");
  EXPECT_EQ(angleOf("21.103+36000000"), "0.00000°");
  EXPECT_EQ(angleOf("21.104+36000000"), "0°00'00.0\"");
  EXPECT_EQ(angleOf("21.105+64000000"), "0.000000000°");
  EXPECT_EQ(angleOf("21.102+40000001"), "400.00001gon") << "beyond it the rules of entries tell of it";
}

TEST(GsiWord, KnowsIndicesOfThreeDigits) {
  const auto words =
      wordsOf("110001+00000001 331.28+00012345 330.08+00012345 21.102+11912345 573..8+00000001");
  std::vector<int> indices;
  for (const GsiWord& word : words) indices.push_back(word.index);
  EXPECT_THAT(indices, ::testing::ElementsAre(11, 331, 330, 21, 573));
}

TEST(GsiWord, KnowsAGsiLine) {
  EXPECT_TRUE(looksLikeGsi("110001+00000001 21"));
  EXPECT_TRUE(looksLikeGsi("  *41....+0000000000000180"));
  EXPECT_FALSE(looksLikeGsi("axis,point,horizontal"));
  EXPECT_FALSE(looksLikeGsi("11"));
  EXPECT_FALSE(looksLikeGsi(""));
}

TEST(GsiWord, NamesWords) {
  const std::map<int, std::string> ofTheManual{{11, "point"},
                                               {12, "serial number"},
                                               {13, "instrument type"},
                                               {16, "station"},
                                               {17, "date"},
                                               {18, "time"},
                                               {19, "time"},
                                               {21, "horizontal circle"},
                                               {22, "vertical circle"},
                                               {25, "difference of the horizontal circle"},
                                               {31, "slope distance"},
                                               {32, "horizontal distance"},
                                               {33, "height difference"},
                                               {41, "code"},
                                               {51, "ppm and prism constant"},
                                               {52, "number of measurements"},
                                               {53, "signal strength"},
                                               {58, "prism constant"},
                                               {59, "ppm"},
                                               {81, "easting"},
                                               {82, "northing"},
                                               {83, "height"},
                                               {84, "station easting"},
                                               {85, "station northing"},
                                               {86, "station height"},
                                               {87, "reflector height"},
                                               {88, "instrument height"}};
  for (const auto& [index, name] : ofTheManual) EXPECT_EQ(gsiWordName(index), name) << index;
  EXPECT_EQ(gsiWordName(42), "information 1");
  EXPECT_EQ(gsiWordName(49), "information 8");
  EXPECT_EQ(gsiWordName(50), "word 50");
  EXPECT_EQ(gsiWordName(70), "word 70");
  EXPECT_EQ(gsiWordName(79), "remark 9");
  EXPECT_EQ(gsiWordName(80), "word 80");
  EXPECT_EQ(gsiWordName(43), "information 2");
  EXPECT_EQ(gsiWordName(71), "remark 1");
  EXPECT_EQ(gsiWordName(99), "word 99");
}

}  // namespace
}  // namespace alidade::test
