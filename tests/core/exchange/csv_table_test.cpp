#include "core/exchange/csv_table.h"

#include <gmock/gmock.h>

namespace alidade::test {
namespace {

using ::testing::ElementsAre;

std::vector<std::vector<std::string>> cellsOf(std::string_view text) {
  std::vector<std::vector<std::string>> cells;
  const auto rows = std::get<CsvTable>(parseCsv(text)).rows;
  for (const CsvRow& row : rows) {
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
  const auto remarks = std::get<CsvTable>(parseCsv("a;b\n #1;2\n# the arc's 5\" \"end\n3;4\n")).remarks;
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_EQ(remarks[0].line, 2u);
  EXPECT_EQ(remarks[0].cells.at(0).text + "|" + remarks[0].cells.at(1).text, "1|2");
  EXPECT_EQ(remarks[1].line, 3u) << "a quote left open is no matter in a remark";
}

TEST(CsvTable, KnowsLineAndColumn) {
  const auto rows = std::get<CsvTable>(parseCsv("a;b;c\r\n\"1\n2\";°°;  x\r\n4;5")).rows;
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1].line, 2u);
  EXPECT_EQ(rows[1].cells[2].column, 9u) << "counted in the line the cell stands in, in characters";
  EXPECT_EQ(rows[2].line, 4u);
}

TEST(CsvTable, NamesAQuoteLeftOpen) {
  const LineProblem problem = std::get<LineProblem>(parseCsv("a,b\n1,\"2\n3,4\n"));
  EXPECT_EQ(problem.line, 2u);
  EXPECT_EQ(problem.column, 3u);
}

}  // namespace
}  // namespace alidade::test
