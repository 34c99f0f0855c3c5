#include "app/console/text_layout.h"

#include <gtest/gtest.h>

namespace alidade::console {
namespace {

TEST(TextLayout, AlignsByWhatIsSeenNotByBytes) {
  EXPECT_EQ(alignedColumns({{"σ", "1.0"}, {"ab", "−12.5"}}), "σ     1.0\nab  −12.5\n");
}

TEST(TextLayout, TakesRowsOfDifferentLength) {
  EXPECT_EQ(alignedColumns({{"a", "b", "c"}, {"long"}, {"", "x"}}), "a     b  c\nlong\n      x\n");
  EXPECT_EQ(alignedColumns({}), "");
}

TEST(TextLayout, BreaksParagraphsAtBlanks) {
  EXPECT_EQ(paragraph("one two three", 2, 7), "one two\n  three\n");
  EXPECT_EQ(paragraph("a word-longer-than-the-line b", 0, 5), "a\nword-longer-than-the-line\nb\n");
  EXPECT_EQ(paragraph("fünf", 0, 4), "fünf\n");
  EXPECT_EQ(paragraph("", 2, 10), "\n");
}

TEST(TextLayout, KeepsUnitsWithTheirNumbers) {
  EXPECT_EQ(paragraph("about 0.1 % of 12 mm, or 3", 0, 9), "about\n0.1 % of\n12 mm, or\n3\n");
}

}  // namespace
}  // namespace alidade::console
