#include "core/base/visible_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/utf8.h"

namespace alidade {
namespace {

std::string utf8(char32_t code) {
  const auto byte = [](char32_t bits) { return static_cast<char>(bits); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | code >> 6), byte(0x80 | (code & 0x3F))};
  if (code < 0x10000)
    return {byte(0xE0 | code >> 12), byte(0x80 | (code >> 6 & 0x3F)), byte(0x80 | (code & 0x3F))};
  return {byte(0xF0 | code >> 18), byte(0x80 | (code >> 12 & 0x3F)), byte(0x80 | (code >> 6 & 0x3F)),
          byte(0x80 | (code & 0x3F))};
}

TEST(VisibleText, EscapesWhatActsOnATerminal) {
  EXPECT_EQ(visibleText("\x1b[31mred\x07\r\n\t\x7f"), "\\u001b[31mred\\u0007\\u000d\\u000a\\u0009\\u007f");
  EXPECT_EQ(visibleText("\u009b2J"), "\\u009b2J") << "C1: the one-byte form of ESC [";
  EXPECT_EQ(visibleText(std::string("a\0b", 3)), "a\\u0000b");
}

TEST(VisibleText, EscapesWhatTurnsOrHidesText) {
  EXPECT_EQ(visibleText("\u202Egnp.exe"), "\\u202egnp.exe");
  EXPECT_EQ(visibleText("a\u2066b\u2069\u200E\u200F\u061C"), "a\\u2066b\\u2069\\u200e\\u200f\\u061c");
  EXPECT_EQ(visibleText("one\u2028two\u2029"), "one\\u2028two\\u2029");
  EXPECT_EQ(visibleText("s\u200Bs\u00ADs\uFEFFs\u2060s\u3164"), "s\\u200bs\\u00ads\\ufeffs\\u2060s\\u3164");
  EXPECT_EQ(visibleText("a\U000E0041"), "a\\udb40\\udc41");
}

TEST(VisibleText, KeepsWhatIsSeen) {
  for (const char* text : {"341°52′24″ ± 0.5 mm, Δd", "Łódź, 北京, Ελλάδα, שלום, سلام",
                           "<b>&amp;</b> C:\\new", "a\u00A0b", "e\u0301", "𝛼"})
    EXPECT_EQ(visibleText(text), text);
}

TEST(VisibleText, KeepsJoinersBehindWhatTheyShape) {
  for (const char* text : {"می\u200Cخواهم", "क्\u200Dष", "👩\u200D🔬", "❤\uFE0F\u200D🔥", "葛\U000E0100"})
    EXPECT_EQ(visibleText(text), text);
  EXPECT_EQ(visibleText("pay\u200Cpal \u200D"), "pay\\u200cpal \\u200d");
  EXPECT_EQ(visibleText("ی\u200C\u200C"), "ی\u200C\\u200c") << "a run of them is not seen";
  EXPECT_EQ(visibleText("ی\u202E\u200C"), "ی\\u202e\\u200c");
  EXPECT_EQ(visibleText("1\uFE0F"), "1\\ufe0f");
}

TEST(VisibleText, ShowsBytesThatAreNoText) {
  EXPECT_EQ(visibleText("a\xFF\xC2 \xE2\x80"), "a\\xff\\xc2 \\xe2\\x80");
  EXPECT_EQ(wellFormed("a\xFF\u202E\xED\xA0\x80"), "a\\xff\u202E\\xed\\xa0\\x80");
  EXPECT_EQ(wellFormed(""), "");
}

TEST(VisibleText, KeepsTheControlCharactersItIsTold) {
  EXPECT_EQ(visibleText("a\nb\tc\r", "\n\t"), "a\nb\tc\\u000d");
}

// Character by character, compared with a second implementation of the forbidden characters.
TEST(VisibleText, LeavesNothingHiddenOfAllUnicode) {
  std::size_t escaped = 0;
  for (char32_t code = 0; code <= 0x10FFFF; ++code) {
    if (code >= 0xD800 && code <= 0xDFFF) continue;
    const std::string text = utf8(code), shown = visibleText(text);
    ASSERT_FALSE(firstIllFormedByte(shown)) << std::hex << static_cast<unsigned>(code);
    const bool forbidden = code < 0x20 || (code >= 0x7F && code <= 0x9F) || code == 0x61C || code == 0xAD ||
                           (code >= 0x200B && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
                           (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF;
    ASSERT_TRUE(!forbidden || shown != text) << std::hex << static_cast<unsigned>(code);
    if (shown != text) ++escaped;
  }
  // 65 Cc, 2 Zl and Zp, 3 of annotation, and the 4174 of DerivedCoreProperties.txt 15.0.
  EXPECT_EQ(escaped, 65u + 2 + 3 + 4174);
}

// The same JSON document, without hidden characters in its strings.
TEST(VisibleText, MeansTheSameWithinJson) {
  const std::string title = "\x1b\u009b\u202E\u2028\x7f\U000E0041\\u0041 \"<b>\"";
  const std::string dumped = nlohmann::json{{"title", title}}.dump(2);
  const std::string shown = visibleText(dumped, "\n");
  EXPECT_EQ(nlohmann::json::parse(shown).at("title"), title);
  EXPECT_EQ(shown.find("\u202E"), std::string::npos);
  EXPECT_EQ(visibleText(shown, "\n"), shown);
}

TEST(Quotation, IsShortAndVisible) {
  EXPECT_EQ(quotation("341°"), "“341°”");
  EXPECT_EQ(quotation("a\nb\xFF"), "“a\\u000ab\\xff”");
  EXPECT_EQ(quotation(std::string(40, 'x')), "“" + std::string(40, 'x') + "”");
  EXPECT_EQ(quotation(std::string(41, 'x')), "“" + std::string(40, 'x') + "…”");
  EXPECT_EQ(shortened("\x1b\x1b\x1b", 2), "\\u001b\\u001b…");
}

}  // namespace
}  // namespace alidade
