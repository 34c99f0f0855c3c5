#include "core/base/typed_text.h"

#include <gtest/gtest.h>

#include <string>

namespace alidade {
namespace {

TEST(TypedText, ReplacesTypographicSigns) {
  EXPECT_EQ(plainSigns("−12º30′05″"), "-12°30'05\"");
  EXPECT_EQ(plainSigns("12˚30’05”"), "12°30'05\"");
}

TEST(TypedText, TrimsAllKindsOfBlanks) {
  EXPECT_EQ(plainSigns("\t\u00A0 341\u202F52\u2009 "), "341 52");
  EXPECT_EQ(plainSigns(" \t "), "");
}

TEST(TypedText, ReplacesWhatKeyboardsAndPdfsGive) {
  EXPECT_EQ(plainSigns("107◦12´23´´"), "107°12'23''");
  EXPECT_EQ(plainSigns("107∘12`23ʺ"), "107°12'23\"");
  EXPECT_EQ(plainSigns("–107⁰12‘23“"), "-107°12'23\"");
  EXPECT_EQ(plainSigns("１０７：１２：２３．５　"), "107:12:23.5");
  EXPECT_EQ(plainSigns("＋１，５；－２"), "+1,5;-2");
}

TEST(TypedText, KeepsPlainSigns) {
  for (char c = ' '; c <= '~'; ++c) {
    if (c == '`') continue;
    const std::string text = "1" + std::string(1, c) + "2";
    EXPECT_EQ(plainSigns(text), text);
  }
}

TEST(TypedText, KnowsDigitsOfOtherScripts) {
  EXPECT_TRUE(hasForeignDigits("١٠٧"));
  EXPECT_TRUE(hasForeignDigits("1०"));
  EXPECT_FALSE(hasForeignDigits("107°12′ 点"));
}

TEST(TypedText, KeepsBytesThatAreNoCharacters) {
  EXPECT_EQ(plainSigns("1\xFF"), "1\xFF");
}

}  // namespace
}  // namespace alidade
