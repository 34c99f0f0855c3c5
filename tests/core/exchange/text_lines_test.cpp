#include "core/exchange/text_lines.h"

#include <gmock/gmock.h>

#include <vector>

namespace alidade::test {
namespace {

using ::testing::HasSubstr;

std::vector<TextLine> linesOf(std::string_view text) {
  std::vector<TextLine> all;
  TextLines lines(text);
  while (const auto line = lines.next()) all.push_back(*line);
  return all;
}

TEST(TextLines, PartsAtEveryKindOfLineEnd) {
  const auto lines = linesOf("a\r\nb\rc\n\nd");
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[1].text, "b");
  EXPECT_EQ(lines[3].text, "");
  EXPECT_EQ(lines[4].text, "d");
  EXPECT_EQ(lines[4].number, 5u);
  EXPECT_TRUE(linesOf("").empty());
  EXPECT_EQ(linesOf("a\n").size(), 1u);
}

TEST(CharacterCount, CountsCharactersNotBytes) {
  EXPECT_EQ(characterCount("341°52′"), 7u);
  EXPECT_EQ(characterCount(""), 0u);
}

// The bytes Windows-1252 writes for 88°16’49” and –.
TEST(Utf8Text, ReadsWhatSpreadsheetsWrite) {
  EXPECT_EQ(*utf8Text("88\xB0"
                      "16\x92"
                      "49\x94 \x96"),
            "88°16’49” –");
  EXPECT_EQ(*utf8Text("\xEF\xBB\xBF"
                      "88°"),
            "88°");
  EXPECT_EQ(*utf8Text("88°"), "88°");
}

TEST(TextLines, EndAtTheEndOfADosFile) {
  TextLines lines("a\nb\x1Az\nd");
  EXPECT_EQ(lines.next()->text, "a");
  EXPECT_EQ(lines.next()->text, "b");
  EXPECT_FALSE(lines.next());
  EXPECT_EQ(lines.tailLine(), 2u);
}

std::string textOf(std::string_view bytes) {
  const Result<std::string> text = utf8Text(bytes);
  return text ? *text : "refused: " + text.problem().what;
}

TEST(Utf8Text, ReadsUtf16) {
  using namespace std::string_view_literals;
  EXPECT_EQ(textOf("\xFF\xFE"
                   "8\0\xB0\0\n\0"sv),
            "8°\n");
  EXPECT_EQ(textOf("\xFE\xFF"
                   "\0"
                   "8\0\xB0\0\n"sv),
            "8°\n");
  EXPECT_EQ(textOf("1\0,\0"
                   "2\0\r\0\n\0"sv),
            "1,2\r\n")
      << "without a mark";
  EXPECT_EQ(textOf("\xFF\xFE\x1A\x4E\x1A\0z\0"sv), "\u4E1A\x1A") << "half a character is no ^Z";
  EXPECT_THAT(textOf("\xFF\xFE"
                     "a"sv),
              HasSubstr("UTF-16"));
  EXPECT_THAT(textOf("\xFF\xFE"
                     "\0\xDC"
                     "a\0"sv),
              HasSubstr("save it as UTF-8"));
}

// 点号,水平角 in GBK; Größe, Straße and 12°30´ in Windows-1252; Точка and УГОЛ in Windows-1251.
TEST(Utf8Text, RecognisesTheEncodingOfNames) {
  EXPECT_EQ(textOf("\xB5\xE3\xBA\xC5,\xCB\xAE\xC6\xBD\xBD\xC7\n1,2"), "点号,水平角\n1,2");
  EXPECT_EQ(textOf("\xB5\xE3"), "点");
  EXPECT_EQ(textOf("Gr\xF6\xDF"
                   "e,Stra\xDF"
                   "e"),
            "Größe,Straße");
  EXPECT_EQ(textOf("12\xB0"
                   "30\xB4"),
            "12°30´");
  EXPECT_EQ(textOf("B\xD6"
                   "DEN1\xC4 2"),
            "BÖDEN1Ä 2");
  EXPECT_EQ(textOf("\xD2\xEE\xF7\xEA\xE0;\xD3\xC3\xCE\xCB"), "Точка;УГОЛ");
}

TEST(Utf8Text, LeavesOutWhatInstrumentsSendBesideText) {
  using namespace std::string_view_literals;
  EXPECT_EQ(textOf("\x02\x07line 1\r\n\x0Cline 2\r\n\x03"sv), "line 1\r\nline 2\r\n");
  EXPECT_EQ(textOf("\0\0line\0\0\n\0\0"sv), "line  \n") << "NUL fills up";
  EXPECT_EQ(textOf("line\n\x1A"), "line\n");
  EXPECT_EQ(textOf("line\n\x1A\x1A\0\r\n"sv), "line\n") << "nothing to tell of";
  EXPECT_EQ(textOf("88\xC2\xB0\n\x1A\xFF\0what"sv), "88°\n\x1A") << "its encoding is that before ^Z";
}

TEST(Utf8Text, RefusesWhatIsNoText) {
  EXPECT_THAT(textOf(std::string_view("a\0b", 3)), HasSubstr("is not a text file"));
}

}  // namespace
}  // namespace alidade::test
