#include "core/exchange/csv_text.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/exchange/csv_table.h"

namespace alidade::test {
namespace {

std::vector<std::string> cellsOf(CsvTable& table) {
  std::vector<std::string> cells;
  if (const auto row = table.next())
    for (const CsvCell& cell : row->cells) cells.push_back(cell.text);
  return cells;
}

TEST(CsvText, NoSpreadsheetTakesATextForAFormula) {
  for (const char* text : {"=1+1", "+CMD|' /C calc'!A0", "-2+3", "@SUM(A1)", "\t=1", "'=1", "''+x"}) {
    const std::string cell = asPlainCell(text);
    EXPECT_EQ(cell, "'" + std::string(text));
    EXPECT_EQ(fromPlainCell(cell), text);
  }
}

TEST(CsvText, NumbersAndAnglesStayWhatTheyAre) {
  for (const char* text : {"-12.5", "+3", "-0,25", "-12°30'", "+341 52 24", "-1.5e-3", "-12.5gon"}) {
    EXPECT_EQ(asPlainCell(text), text);
    EXPECT_EQ(fromPlainCell(text), text);
  }
  for (const char* text : {"", "'", "''", "a=b", "it's", "'quoted'", "1-2"}) {
    EXPECT_EQ(asPlainCell(text), text);
    EXPECT_EQ(fromPlainCell(text), text) << "an apostrophe of somebody's own";
  }
}

TEST(CsvText, ReadsBackByTheTable) {
  CsvText csv{"a", "b", "c"};
  csv.typed("341°52'24\"").typed("x, y;z\tw").typed("say \"so\"").endRow();
  csv.typed("# no remark").number(0.1).count(-7).endRow();
  csv.number(std::numeric_limits<double>::quiet_NaN()).number(std::numeric_limits<double>::infinity());
  csv.word("end").endRow();
  CsvTable table(csv.text());
  EXPECT_EQ(cellsOf(table), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(cellsOf(table), (std::vector<std::string>{"341°52'24\"", "x, y;z\tw", "say \"so\""}));
  EXPECT_EQ(cellsOf(table), (std::vector<std::string>{"# no remark", "0.1", "-7"}));
  EXPECT_EQ(cellsOf(table), (std::vector<std::string>{"", "", "end"}));
  EXPECT_FALSE(table.problem());
}

}  // namespace
}  // namespace alidade::test
