#include "core/base/number_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace alidade {
namespace {

using testing::HasSubstr;

TEST(NumberText, ReadsNumbersAsTyped) {
  const std::pair<const char*, double> typed[] = {
      {"2405", 2405},       {"2405,5", 2405.5}, {" 2405.5 ", 2405.5}, {"+3", 3},   {"−0.25", -0.25},
      {"-1.5e-3", -1.5e-3}, {"1E3", 1000},      {".5", 0.5},          {"5.", 5},   {"\u00A07", 7},
      {"5e-324", 5e-324},   {"0e-400", 0},      {"007", 7},           {"0.1", 0.1}};
  for (const auto& [text, value] : typed) {
    const Result<double> number = parseNumber(text);
    ASSERT_TRUE(number) << text << ": " << number.problem().what;
    EXPECT_EQ(*number, value) << text;
  }
}

TEST(NumberText, RefusesWhatIsNoSingleNumber) {
  const std::pair<const char*, const char*> refused[] = {
      {"", "is empty: type a number"},
      {"2405 mm", "“2405 mm” contains more than a number: leave out “mm”"},
      {"20°C", "leave out “°C”"},
      {"1,234.5", "“1,234.5” is not one number"},
      {"1 234", "is not one number"},
      {"0x10", "is not one number"},
      {"1e", "leave out “e”"},
      {"nan", "“nan” is not a number"},
      {"inf", "is not a number"},
      {"-inf", "is not a number"},
      {"--1", "is not a number"},
      {".", "is not a number"},
      {"1e400", "too large or too small"},
      {"-1e999", "too large or too small"}};
  for (const auto& [text, sentence] : refused) {
    const Result<double> number = parseNumber(text);
    ASSERT_FALSE(number) << text;
    EXPECT_THAT(number.problem().what, HasSubstr(sentence));
  }
}

TEST(NumberText, ReadsWholeNumbersOfNineDigits) {
  EXPECT_EQ(*parseWhole(" 17 "), 17);
  EXPECT_EQ(*parseWhole("−3"), -3);
  EXPECT_EQ(*parseWhole("+999999999"), 999999999);
  EXPECT_THAT(parseWhole("1000000000").problem().what, HasSubstr("more than nine digits"));
  EXPECT_THAT(parseWhole("2.5").problem().what, HasSubstr("“2.5” is not a whole number"));
  EXPECT_THAT(parseWhole("-").problem().what, HasSubstr("is not a whole number"));
  EXPECT_THAT(parseWhole("").problem().what, HasSubstr("is empty"));
}

TEST(NumberText, ShortestTextReadsBackAsTheSameDouble) {
  EXPECT_EQ(shortestText(2405), "2405");
  EXPECT_EQ(shortestText(100000), "100000");
  EXPECT_EQ(shortestText(0.1), "0.1");
  EXPECT_EQ(shortestText(-1e-7), "-1e-07");
  std::mt19937_64 random(5);
  for (int i = 0; i < 100000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const Result<double> back = parseNumber(shortestText(value));
    ASSERT_TRUE(back) << shortestText(value);
    ASSERT_EQ(*back, value);
  }
}

TEST(NumberText, FixedTextNeverShowsANegativeZero) {
  EXPECT_EQ(fixedText(-0.001, 2), "0.00");
  EXPECT_EQ(fixedText(-0.006, 2), "-0.01");
  EXPECT_EQ(fixedText(1.30764, 3), "1.308");
  EXPECT_EQ(fixedText(-2.6, 0), "-3");
  EXPECT_EQ(fixedText(std::numeric_limits<double>::max(), 1).size(), 311u);
}

}  // namespace
}  // namespace alidade
