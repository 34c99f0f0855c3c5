#include "ui/document/reading_column.h"

#include <gtest/gtest.h>

#include <set>

namespace alidade::ui {
namespace {

TEST(ReadingColumn, HasWordsOfItsOwn) {
  std::set<std::string> titles, tips, nouns;
  for (const ReadingColumnInfo& info : allReadingColumns()) {
    EXPECT_TRUE(titles.insert(info.title).second) << info.title;
    EXPECT_TRUE(tips.insert(info.toolTip).second) << info.title;
    EXPECT_EQ(info.noun == nullptr, info.field == nullptr) << info.title;
    if (info.noun) {
      EXPECT_TRUE(nouns.insert(info.noun).second) << info.title;
    }
  }
}

// A column without a width of its own shares that of the angles; a printed one has a width on paper.
TEST(ReadingColumn, HasRoom) {
  for (const ReadingColumnInfo& info : allReadingColumns()) {
    EXPECT_EQ(info.widest == nullptr, isAngle(info.column)) << info.title;
    EXPECT_EQ(info.printedTitle != nullptr, info.printedWidth > 0) << info.title;
    if (info.printedTitle) {
      EXPECT_TRUE(readingText(info.column)) << info.title;
    }
  }
}

TEST(ReadingColumn, IsFoundByTheNameInTheFile) {
  EXPECT_EQ(readingColumn("slider"), ReadingColumn::Slider);
  EXPECT_EQ(readingColumn("excluded"), ReadingColumn::Used);
  for (const ReadingColumnInfo& info : allReadingColumns())
    if (info.field) {
      EXPECT_EQ(readingColumn(std::string(info.field->key)), info.column) << info.title;
    }
  for (const char* strange : {"", "axis_deg", "pointing_zero.vertical"})
    EXPECT_EQ(readingColumn(strange), ReadingColumn::Horizontal) << strange;
}

// An entry in one column is read back from it, and no other field of the row changes.
TEST(ReadingColumn, EntersItsOwnFieldOnly) {
  for (const ReadingColumnInfo& info : allReadingColumns()) {
    EXPECT_EQ(isEntered(info.column), info.field != nullptr) << info.title;
    if (!isEntered(info.column)) continue;
    Reading row;
    enter(row, info.column, "0");
    for (const ReadingColumnInfo& other : allReadingColumns()) {
      if (!isEntered(other.column)) continue;
      const std::string untouched = other.column == ReadingColumn::Used ? "1" : "";
      EXPECT_EQ(enteredText(row, other.column), other.column == info.column ? "0" : untouched)
          << info.title << ", " << other.title;
    }
    enter(row, info.column, enteredText({}, info.column));
    EXPECT_EQ(row, Reading());
  }
}

}  // namespace
}  // namespace alidade::ui
