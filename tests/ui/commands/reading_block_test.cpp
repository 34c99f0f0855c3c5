#include "ui/commands/reading_block.h"

#include <gtest/gtest.h>

namespace alidade::ui {
namespace {

QString text(const char* utf8) {
  return QString::fromUtf8(utf8);
}

// Tabs and LF between cells and rows only; a character that would split a cell becomes one blank.
TEST(BlockText, PartsCellsByTabsAndRowsByLineFeeds) {
  EXPECT_EQ(blockText({}), QString());
  EXPECT_EQ(blockText({{text("1")}}), text("1"));
  EXPECT_EQ(blockText({{text("1"), QString(), text("x\t\r\ny")}, {}, {QString(), text("°")}}),
            text("1\t\tx y\n\n\t°"));
}

TEST(BlockText, IsReadBackAsItWas) {
  const ReadingBlock block{
      {text("341 52 24"), text("88°16′49″")}, {text("2"), QString()}, {text("3"), text("a b")}};
  EXPECT_EQ(parseBlock(blockText(block)), block);
}

// Table I as typed into a spreadsheet: degrees are never read alone.
TEST(ReadingBlock, WithAnglesInPartsIsNotRead) {
  const ReadingBlock parts =
      parseBlock(QStringLiteral("1\t341\t52\t24\t88\t16\t49\n2\t339\t54\t27.5\t86\t39\t12\n"));
  const auto named = namedBlock(parts);
  ASSERT_TRUE(named);
  EXPECT_FALSE(named->problem.isEmpty());
  EXPECT_FALSE(namedBlock(parseBlock(QStringLiteral("1\t1\t1\t341 52 24\t88 16 49\t12.5\n"))));
  EXPECT_FALSE(namedBlock(parseBlock(QStringLiteral("341\t52\t24\t88\t61\t49\n"))));
}

}  // namespace
}  // namespace alidade::ui
