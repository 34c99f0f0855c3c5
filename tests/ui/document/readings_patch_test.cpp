#include "ui/document/readings_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/session/session_file.h"
#include "tests/ui/support.h"

namespace alidade::ui {
namespace {

using Rows = std::vector<Reading>;

Rows rowsOf(std::size_t count) {
  Rows rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    rows[i].point = std::to_string(i + 1);
    rows[i].vertical = "85 10 " + std::to_string(i % 60);
  }
  return rows;
}

/// Applies and reverts the patch; the span states which rows changed.
void expectThereAndBack(const ReadingsPatch& patch, const Rows& before, const Rows& after) {
  Rows rows = before;
  patch.apply(rows);
  EXPECT_EQ(rows, after);
  const RowSpan span = patch.span();
  ASSERT_LE(span.first + span.before, before.size());
  ASSERT_EQ(before.size() - span.before + span.after, after.size());
  EXPECT_TRUE(
      std::equal(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(span.first), after.begin()));
  EXPECT_TRUE(std::equal(before.begin() + static_cast<std::ptrdiff_t>(span.first + span.before), before.end(),
                         after.begin() + static_cast<std::ptrdiff_t>(span.first + span.after)));
  patch.revert(rows);
  EXPECT_EQ(rows, before);
}

TEST(ReadingsPatch, EntersTextsAndAppends) {
  const Rows before = rowsOf(5);
  Rows after = before;
  after[1].horizontal = "12";
  after[4].excluded = true;
  after.push_back(rowsOf(1).front());
  const ReadingsPatch patch(before,
                            {{1, ReadingColumn::Horizontal, "12"},
                             {4, ReadingColumn::Used, "0"},
                             {2, ReadingColumn::Point, "3"},
                             {9, ReadingColumn::Point, "3"}},
                            rowsOf(1));
  EXPECT_EQ(patch.cellCount(), 2u) << "what says the same, and what is not there, is no change";
  expectThereAndBack(patch, before, after);
}

TEST(ReadingsPatch, ClearsTextsWhereThereAreAny) {
  Rows before = rowsOf(4);
  before[2].horizontal = "12 30 00";
  before[2].excluded = true;
  Rows after = before;
  after[2].horizontal.clear();
  after[2].vertical.clear();
  after[0].point.clear();
  const ReadingsPatch patch = ReadingsPatch::clearing(before, {{2, ReadingColumn::Horizontal},
                                                               {2, ReadingColumn::Vertical},
                                                               {2, ReadingColumn::Used},
                                                               {2, ReadingColumn::HorizontalResidual},
                                                               {1, ReadingColumn::Note},
                                                               {0, ReadingColumn::Point},
                                                               {4, ReadingColumn::Point}});
  EXPECT_EQ(patch.cellCount(), 3u) << "no empty cell, no tick, no residual, no row that is not there";
  expectThereAndBack(patch, before, after);
  EXPECT_TRUE(ReadingsPatch::clearing(before, {{1, ReadingColumn::Note}}).isEmpty());
  EXPECT_TRUE(ReadingsPatch::clearing({}, {{0, ReadingColumn::Point}}).isEmpty());
}

TEST(ReadingsPatch, DoesAndUndoesWhatStdVectorDoes) {
  std::mt19937 random(1);
  const auto upTo = [&](std::size_t most) {
    return std::uniform_int_distribution<std::size_t>(0, most)(random);
  };
  for (int trial = 0; trial < 500; ++trial) {
    const Rows before = rowsOf(upTo(12));
    const std::size_t first = upTo(before.size()), removed = upTo(before.size() - first);
    const auto at = before.begin() + static_cast<std::ptrdiff_t>(first);
    Rows inserted(at, at + static_cast<std::ptrdiff_t>(std::min(removed, upTo(4))));
    for (Reading& reading : inserted)
      if (upTo(1) == 0) reading.note = "edited";
    for (std::size_t i = upTo(3); i > 0; --i) inserted.push_back(rowsOf(3)[upTo(2)]);
    Rows after = before;
    const auto gap = after.erase(after.begin() + static_cast<std::ptrdiff_t>(first),
                                 after.begin() + static_cast<std::ptrdiff_t>(first + removed));
    after.insert(gap, inserted.begin(), inserted.end());
    expectThereAndBack(ReadingsPatch::replacing(before, first, removed, inserted), before, after);
  }
}

TEST(ReadingsPatch, RemovesRowsWhereverTheyStand) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 300; ++trial) {
    const Rows before = rowsOf(10);
    std::vector<std::size_t> gone;
    Rows after;
    for (std::size_t row = 0; row < before.size(); ++row) {
      if (random() % 3 == 0)
        gone.push_back(row);
      else
        after.push_back(before[row]);
    }
    std::shuffle(gone.begin(), gone.end(), random);
    gone.push_back(99);
    expectThereAndBack(ReadingsPatch::removing(before, gone), before, after);
  }
}

TEST(ReadingsPatch, HoldsNoMoreThanWhatChanged) {
  const Rows rows = rowsOf(50000);
  EXPECT_EQ(ReadingsPatch(rows, {{7, ReadingColumn::Vertical, "1"}}).cellCount(), 1u);
  const ReadingsPatch ends = ReadingsPatch::removing(rows, {0, 49999});
  EXPECT_EQ(ends.rowCount(), 2u) << "and none of those between";
  std::vector<NewText> exclude;
  for (const std::size_t row : {0, 49999}) exclude.push_back({row, ReadingColumn::Used, "0"});
  const ReadingsPatch excluded(rows, exclude);
  EXPECT_EQ(excluded.cellCount(), 2u);
  EXPECT_EQ(excluded.rowCount(), 0u);
}

TEST(ReadingsPatch, KeepsWhatTheFileSaidOfARow) {
  std::string text = writeSession(paperSession());
  const auto place = text.find("\"point\"");
  ASSERT_NE(place, std::string::npos);
  text.insert(place, "\"weather\": \"fog\", ");
  Session session = *readSession(text);
  const std::string before = writeSession(session);
  Rows& rows = session.positions.front().readings;
  const ReadingsPatch patch(rows, {{0, ReadingColumn::Vertical, "1"}});
  patch.apply(rows);
  EXPECT_NE(writeSession(session).find("fog"), std::string::npos);
  patch.revert(rows);
  const ReadingsPatch gone = ReadingsPatch::removing(rows, {0});
  gone.apply(rows);
  EXPECT_EQ(writeSession(session).find("fog"), std::string::npos);
  gone.revert(rows);
  EXPECT_EQ(writeSession(session), before);
}

}  // namespace
}  // namespace alidade::ui
