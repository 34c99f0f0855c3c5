#include "core/base/utf8.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(Utf8, DecodesCharactersOfEveryLength) {
  EXPECT_EQ(firstCharacter("A").code, U'A');
  EXPECT_EQ(firstCharacter("°").code, U'°');
  EXPECT_EQ(firstCharacter("″").code, U'″');
  EXPECT_EQ(firstCharacter("𝛼").code, U'𝛼');
  EXPECT_EQ(firstCharacter("𝛼").length, 4u);
  EXPECT_EQ(firstCharacter("").length, 0u);
}

TEST(Utf8, FindsTheFirstIllFormedByte) {
  EXPECT_FALSE(firstIllFormedByte("341°52′24″ 𝛼"));
  EXPECT_EQ(firstIllFormedByte("ab\xFF"), 2u);
  EXPECT_EQ(firstIllFormedByte("°\xC2"), 2u) << "cut off";
  EXPECT_EQ(firstIllFormedByte("\xC0\xAF"), 0u) << "overlong";
  EXPECT_EQ(firstIllFormedByte("\xE0\x80\xAF"), 0u) << "overlong";
  EXPECT_EQ(firstIllFormedByte("\xED\xA0\x80"), 0u) << "surrogate";
  EXPECT_EQ(firstIllFormedByte("\xF4\x90\x80\x80"), 0u) << "beyond Unicode";
}

}  // namespace
}  // namespace alidade
