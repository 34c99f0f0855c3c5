#include "core/base/typed_text.h"

#include <gtest/gtest.h>

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

TEST(TypedText, KeepsBytesThatAreNoCharacters) {
  EXPECT_EQ(plainSigns("1\xFF"), "1\xFF");
}

}  // namespace
}  // namespace alidade
