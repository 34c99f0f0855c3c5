#include "core/series/history/value_table.h"

#include <gmock/gmock.h>

namespace alidade {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

ValueTable read(const std::string& text) {
  const Result<ValueTable> table = readValueTable(text);
  EXPECT_TRUE(table) << text << ": " << (table ? "" : table.problem().text());
  return table ? *table : ValueTable();
}

void expectTwo(const std::string& text) {
  const ValueTable table = read(text);
  ASSERT_THAT(table.values, SizeIs(2)) << text;
  EXPECT_EQ(table.values[0].date, "2001-02-03") << text;
  EXPECT_DOUBLE_EQ(table.values[0].value, 1.5) << text;
  EXPECT_NEAR(table.values[0].u, 0.25, 1e-15) << text;
  EXPECT_DOUBLE_EQ(table.values[1].value, -2) << text;
  EXPECT_NEAR(table.values[1].u, 0.5, 1e-15) << text;
  EXPECT_LT(table.values[0].day, table.values[1].day) << text;
}

TEST(ValueTable, IsTheSameHoweverItIsParted) {
  for (const char* text :
       {"2001-02-03,1.5,0.25\n2002-02-03,-2,0.5\n", "2001-02-03;1,5;0,25\r\n2002-02-03;-2;0,5",
        "2001-02-03\t1.5\t0.25\n\n2002-02-03\t-2\t0.5\n", "2001-02-03 1.5 0.25\n2002-02-03 -2 0.5\n",
        "2001-02-03  1,5  0,25\n2002-02-03  -2  0,5\n", "2001-02-03, 1.5, 0.25\n2002-02-03, -2, 0.5\n",
        "# made by hand\ndate,value,u\n2001-02-03,1.5,0.25\n2002-02-03,-2,0.5\n",
        "\xEF\xBB\xBF"
        "2001-02-03,1.50(25),\n2002-02-03,-2.0(5),\n",
        "2001-02-03;1.50(25)\n2002-02-03;-2.0 ± 0.5\n",
        "2001-02-03,\"1,5\",\"0,25\"\n2002-02-03,-2,\"0,5\"\n"})
    expectTwo(text);
}

TEST(ValueTable, FindsItsColumnsByTheirNames) {
  expectTwo("lab,u [mm],Value [mm],Date\nA,0.25,1.5,2001-02-03\nB,0.5,-2,2002-02-03\n");
  expectTwo("Datum;Messwert;Standardunsicherheit\n2001-02-03;1,5;0,25\n2002-02-03;-2;0,5\n");
  expectTwo("year,x (arcsec),sigma\n2001-02-03,1.5,0.25\n2002-02-03,-2,0.5\n");
  EXPECT_EQ(read("date,value [mm],u\n2001,1,1\n").unit, "mm");
}

TEST(ValueTable, DividesWhatIsNamedExpandedByItsFactor) {
  for (const auto& [heading, u] : {std::pair("U (k=2)", 0.25),
                                   {"U (k=3)", 0.5 / 3},
                                   {"u, k = 2.5", 0.2},
                                   {"U95", 0.25},
                                   {"U (95 %)", 0.25},
                                   {"expanded U", 0.25},
                                   {"Erweiterte Messunsicherheit", 0.25}}) {
    const ValueTable table = read(std::string("date;value;") + heading + "\n2001;1;0.5\n");
    EXPECT_DOUBLE_EQ(table.values[0].u, u) << heading;
    EXPECT_THAT(table.remarks, ElementsAre(HasSubstr("divided by"))) << heading;
  }
  for (const char* heading : {"U", "U (mm)", "U [mm]"})
    EXPECT_THAT(read(std::string("date,value,") + heading + "\n2001,1,0.5\n").remarks,
                ElementsAre(HasSubstr("k = 1")))
        << heading;
  EXPECT_THAT(read("date,value,u (k = 1)\n2001,1,0.5\n").remarks, IsEmpty());
  EXPECT_THAT(read("date,value,u\n2001,1,0.5\n").remarks, IsEmpty());
}

TEST(ValueTable, ReadsParenthesesAtAnyPowerOfTen) {
  const ValueTable table = read("2014,6.67408(31)e-11\n2018,6.67430(15)E-11\n");
  EXPECT_NEAR(table.values[0].value, 6.67408e-11, 1e-24);
  EXPECT_NEAR(table.values[0].u, 0.00031e-11, 1e-24);
}

TEST(ValueTable, TakesYearsAmongDecimalYearsForDecimal) {
  const ValueTable decimal = read("1986,1,1\n1986.5,1,1\n"), whole = read("1986,1,1\n1987,1,1\n");
  EXPECT_NEAR(decimal.values[1].day - decimal.values[0].day, 365.25 / 2, 1e-6);
  EXPECT_NEAR(whole.values[1].day - whole.values[0].day, 365, 1e-6);
}

TEST(ValueTable, LeavesOutLinesWithoutAValueAndSaysSo) {
  const ValueTable table = read("2001,1,0.1\n2002,,0.1\n2003,2,0.1\n");
  EXPECT_THAT(table.values, SizeIs(2));
  EXPECT_THAT(table.remarks, ElementsAre(HasSubstr("line 2")));
}

std::string refusal(const std::string& text) {
  const Result<ValueTable> table = readValueTable(text);
  return table ? "none" : table.problem().text();
}

TEST(ValueTable, RefusesToGuessWhichColumnHoldsTheValue) {
  EXPECT_EQ(refusal("date;temperature;collimation;u\n2024;20.5;3;0.5\n"),
            "each of the columns “temperature” and “collimation” could hold the value: name only one of them "
            "“value” in the first line");
  EXPECT_THAT(refusal("date;collimation;u;index;u index\n2020;1;0.1;7;.3\n"),
              HasSubstr("“collimation” and “index”"));
  EXPECT_THAT(refusal("1;2020-01-01;1.0;0.1\n2;2021-01-01;1.2;0.2\n"), HasSubstr("columns 1, 3 and 4"));
  EXPECT_THAT(refusal("date;x;y;u\n2020;1;2;0.1\n"), HasSubstr("“x” and “y” could hold the value"));
  EXPECT_THAT(
      refusal("date;value;sigma;error\n2020;1;0.1;0.2\n"),
      HasSubstr("“sigma” and “error” could hold the standard uncertainty: name only one of them “u”"));
  EXPECT_THAT(refusal("date;u;x;value\n2020;1\n2021;1\n"), HasSubstr("holds no value"));
  EXPECT_THAT(refusal("date;value;a;b\n2020;1;0.1;0.2\n"), HasSubstr("“a” and “b” could hold the standard"));
  EXPECT_THAT(refusal("date;temperature;collimation;u\n2024;20.5;;0.5\n2025;20.5;3;0.5\n"),
              HasSubstr("“temperature” and “collimation”"))
      << "blank in the first line";
}

TEST(ValueTable, TakesTheColumnsThatItsUserNames) {
  expectTwo("date;mean temperature;value;u;U (k=2)\n2001-02-03;20;1.5;0.25;.5\n2002-02-03;20;-2;0.5;1\n");
  expectTwo("no;n;date;value;u;note\n1;17;2001-02-03;1.5;0.25;7\n2;17;2002-02-03;-2;0.5;\n");
  expectTwo("date;collimation;u;note\n2001-02-03;1.5;0.25;good\n2002-02-03;-2;0.5;7\n");
  expectTwo("date;n;collimation\n2001-02-03;17;1.50(25)\n2002-02-03;17;-2.0(5)\n");
}

TEST(ValueTable, RefusesAnUncertaintyInAnotherUnit) {
  EXPECT_EQ(refusal("date;value (mm);u (µm)\n2024;0.3;10\n"),
            "the columns “value (mm)” and “u (µm)” state different units: give the value and its uncertainty "
            "in one unit");
  for (const char* names : {"x (mm);u(x)", "value [″];u (arcsec)", "value (µm);u [um]", "value (mm);U (95 %)",
                            "value (mm);u (k = 1)", "value;u (mm)", "value (mm);u(x) (mm)"})
    EXPECT_EQ(refusal(std::string("date;") + names + "\n2024;0.3;10\n"), "none") << names;
}

TEST(ValueTable, SaysWhereItCannotBeUsed) {
  EXPECT_THAT(refusal("2001,1,0.1\n2002,1,0\n"), HasSubstr("line 2, column 8: the standard uncertainty 0"));
  EXPECT_THAT(refusal("2001,1,0.1\n2002,1,-0.1\n"), HasSubstr("line 2"));
  EXPECT_THAT(refusal("2001,1,0.1\n2002,1,\n"), HasSubstr("no standard uncertainty"));
  EXPECT_THAT(refusal("2001,1\n2002,1\n"), HasSubstr("no standard uncertainty"));
  EXPECT_THAT(refusal("2001,1,1e-320\n"), HasSubstr("line 1"));
  // A weighted mean of these does not exist: its terms exceed the range of numbers.
  EXPECT_THAT(refusal("2001,1e308,1e-150\n"), HasSubstr("line 1, column 6: 1e+308 is out of range"));
  EXPECT_THAT(refusal("2001,1,1e31\n"), HasSubstr("line 1, column 8: 1e+31 is out of range"));
  EXPECT_EQ(refusal("2001,-1e30,1e-30\n2002,1e30,1e30\n"), "none");
  EXPECT_THAT(refusal("2001,1,0.1\nyesterday,1,0.1\n"),
              HasSubstr("line 2, column 1: “yesterday” is no date"));
  EXPECT_THAT(refusal("2001,1,0.1\n2002,one,0.1\n"), HasSubstr("“one” is no number"));
  EXPECT_THAT(refusal("2001,3,25,0,12\n"), HasSubstr("semicolons"));
  EXPECT_THAT(refusal(""), HasSubstr("holds no value"));
  EXPECT_THAT(refusal("date,value,u\n"), HasSubstr("holds no value"));
  EXPECT_THAT(refusal("1.5,0.2\n1.4,0.2\n"), HasSubstr("no date"));
  EXPECT_THAT(refusal(std::string("2001\0,1,1", 9)), HasSubstr("is not a text file"));
}

}  // namespace
}  // namespace alidade
