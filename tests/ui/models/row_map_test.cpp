#include "ui/models/row_map.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace alidade::ui {
namespace {

/// A reference implementation, row by row.
struct PlainMap {
  struct Row {
    int origin = -1;
    bool isUntouched = true;
  };
  std::vector<Row> rows;

  void replace(std::size_t first, std::size_t removed, std::size_t inserted) {
    const auto from = rows.begin() + static_cast<std::ptrdiff_t>(first);
    if (removed == inserted) {
      for (std::size_t i = 0; i < removed; ++i) rows[first + i].isUntouched = false;
    } else {
      const auto next = rows.erase(from, from + static_cast<std::ptrdiff_t>(removed));
      rows.insert(next, inserted, Row{});
    }
  }
};

TEST(RowMap, KnowsEveryRowAgain) {
  std::mt19937 random(3);
  const auto upTo = [&](std::size_t most) {
    return std::uniform_int_distribution<std::size_t>(0, most)(random);
  };
  for (int trial = 0; trial < 200; ++trial) {
    PlainMap plain;
    for (int row = 0; row < 20; ++row) plain.rows.push_back({row, true});
    RowMap map;
    for (int edit = 0; edit < 12; ++edit) {
      const std::size_t first = upTo(plain.rows.size()), removed = upTo(plain.rows.size() - first);
      const std::size_t inserted = upTo(1) == 0 ? removed : upTo(5);
      plain.replace(first, removed, inserted);
      map.replace(first, removed, inserted);
      for (std::size_t row = 0; row < plain.rows.size(); ++row) {
        const auto origin = map.origin(row);
        ASSERT_EQ(origin.has_value(), plain.rows[row].origin >= 0) << "row " << row;
        if (!origin) continue;
        ASSERT_EQ(static_cast<int>(origin->row), plain.rows[row].origin);
        ASSERT_EQ(origin->isUntouched, plain.rows[row].isUntouched);
      }
    }
  }
}

TEST(RowMap, CostsByTheEditsAndNotByTheRows) {
  RowMap map;
  map.replace(70000, 1, 1);
  EXPECT_EQ(map.pieceCount(), 3u);
  map.replace(70001, 1, 1);
  EXPECT_EQ(map.pieceCount(), 3u) << "neighbours are one piece";
  map.replace(5, 10000, 0);
  EXPECT_EQ(map.origin(60000)->row, 70000u);
  EXPECT_FALSE(map.origin(60000)->isUntouched);
  map.reset();
  EXPECT_EQ(map.pieceCount(), 1u);
}

}  // namespace
}  // namespace alidade::ui
