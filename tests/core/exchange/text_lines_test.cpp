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

TEST(Utf8Text, RefusesWhatIsNoText) {
  EXPECT_THAT(utf8Text("\xFF\xFE"
                       "a")
                  .problem()
                  .what,
              HasSubstr("UTF-16"));
  EXPECT_THAT(utf8Text(std::string_view("a\0b", 3)).problem().what, HasSubstr("no text"));
}

}  // namespace
}  // namespace alidade::test
