#include "core/exchange/csv_table.h"

#include <gmock/gmock.h>

#include "core/base/limits.h"

namespace alidade::test {
namespace {

using ::testing::ElementsAre, ::testing::StartsWith;

std::vector<CsvRow> rowsOf(std::string_view text, bool remarks = false) {
  std::vector<CsvRow> rows;
  CsvTable table(text);
  while (const auto row = table.next())
    if (row->isRemark == remarks) rows.push_back(*row);
  return rows;
}

std::vector<std::vector<std::string>> cellsOf(std::string_view text) {
  std::vector<std::vector<std::string>> cells;
  for (const CsvRow& row : rowsOf(text)) {
    cells.emplace_back();
    for (const CsvCell& cell : row.cells) cells.back().push_back(cell.text);
  }
  return cells;
}

TEST(CsvTable, FindsTheSeparatorInTheFirstRow) {
  EXPECT_THAT(cellsOf("a,b\n1,2"), ElementsAre(ElementsAre("a", "b"), ElementsAre("1", "2")));
  EXPECT_THAT(cellsOf("a;b\n1,5;2"), ElementsAre(ElementsAre("a", "b"), ElementsAre("1,5", "2")));
  EXPECT_THAT(cellsOf("a\tb\n1;5\t"), ElementsAre(ElementsAre("a", "b"), ElementsAre("1;5", "")));
}

TEST(CsvTable, UnquotesAsSpreadsheetsQuote) {
  EXPECT_THAT(cellsOf("a,b\n\"341°52'24\"\"\",\"x,\ny\""),
              ElementsAre(ElementsAre("a", "b"), ElementsAre("341°52'24\"", "x, y")));
  EXPECT_THAT(cellsOf("a,b\n341°52'24\",88°16'49\""),
              ElementsAre(ElementsAre("a", "b"), ElementsAre("341°52'24\"", "88°16'49\"")));
}

TEST(CsvTable, LeavesEmptyRowsAndRemarksOut) {
  EXPECT_THAT(cellsOf("# x;y\n\na,b\n , \n#1,2\n3,4\n"),
              ElementsAre(ElementsAre("a", "b"), ElementsAre("3", "4")));
  EXPECT_THAT(cellsOf("#;Hz\n1;2"), ElementsAre(ElementsAre("#", "Hz"), ElementsAre("1", "2")));
  EXPECT_TRUE(cellsOf("").empty());
}

TEST(CsvTable, TakesRemarksApartBesideTheRows) {
  const auto remarks = rowsOf("a;b\n #1;2\n# the arc's 5\" \"end\n3;4\n", true);
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_EQ(remarks[0].line, 2u);
  EXPECT_EQ(remarks[0].cells.at(0).text + "|" + remarks[0].cells.at(1).text, "1|2");
  EXPECT_EQ(remarks[1].line, 3u) << "a quote left open is no matter in a remark";
}

TEST(CsvTable, KnowsLineAndColumn) {
  const auto rows = rowsOf("a;b;c\r\n\"1\n2\";°°;  x\r\n4;5");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1].line, 2u);
  EXPECT_EQ(rows[1].cells[2].column, 0u) << "another line than its row's: no column of that";
  EXPECT_EQ(rows[2].line, 4u);
}

TEST(CsvTable, CountsColumnsInCharacters) {
  const auto rows = rowsOf("a;b;c\n\"1\";°°;  x\n");
  EXPECT_EQ(rows.at(1).cells.at(2).column, 10u);
}

TEST(CsvTable, NamesAQuoteLeftOpen) {
  CsvTable table("a,b\n1,\"2\n3,4\n");
  EXPECT_TRUE(table.next());
  EXPECT_FALSE(table.next());
  ASSERT_TRUE(table.problem());
  EXPECT_EQ(table.problem()->line, 2u);
  EXPECT_EQ(table.problem()->column, 3u);
}

TEST(CsvTable, EndsBeyondTheColumnsOfAnyTable) {
  const auto lineOf = [](std::size_t cells) {
    std::string line;
    for (std::size_t i = 0; i < cells; ++i) line += i == 0 ? "1" : ",1";
    return line;
  };
  const std::string most = lineOf(limits::mostColumns), more = lineOf(limits::mostColumns + 1);
  CsvTable table(most);
  EXPECT_EQ(table.next()->cells.size(), limits::mostColumns);
  EXPECT_FALSE(table.problem());
  CsvTable tooWide(more);
  EXPECT_FALSE(tooWide.next());
  ASSERT_TRUE(tooWide.problem());
  EXPECT_THAT(tooWide.problem()->text(), StartsWith("line 1, column 2001: has more than 1,000 columns"));
  EXPECT_EQ(rowsOf("#" + lineOf(limits::mostColumns + 5), true).at(0).cells.size(), limits::mostColumns);
}

// The text has one line more than the table may have rows; empty lines do not count.
TEST(CsvTable, EndsBeyondTheRowsThatAreRead) {
  std::string text = "name\n\n";
  for (std::size_t i = 0; i < limits::mostRows; ++i) text += "1\n";
  CsvTable most(text);
  std::size_t rows = 0;
  while (most.next()) ++rows;
  EXPECT_EQ(rows, limits::mostRows + 1);
  EXPECT_FALSE(most.problem());
  text += "1\n";
  CsvTable more(text);
  while (more.next()) continue;
  ASSERT_TRUE(more.problem());
  EXPECT_THAT(more.problem()->text(), StartsWith("line 2000003: comes after 2,000,000 rows"));
}

}  // namespace
}  // namespace alidade::test
