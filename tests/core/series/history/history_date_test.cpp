#include "core/series/history/history_date.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

double dayOf(const char* text) {
  const Result<HistoryDate> date = parseHistoryDate(text);
  EXPECT_TRUE(date) << text;
  return date ? date->day : -1e9;
}

TEST(HistoryDate, IsTheSameDayHoweverItIsWritten) {
  for (const char* text : {"2019-03-07", "2019/3/7", "2019.03.07", "20190307", "7.3.2019", " 2019-03-07 ",
                           "2019-03-07T10:30:00Z", "2019-03-07 10:30"})
    EXPECT_EQ(dayOf(text), dayOf("2019-03-07")) << text;
}

TEST(HistoryDate, CountsDaysOfTheCalendar) {
  EXPECT_EQ(dayOf("2000-01-01"), 0);
  EXPECT_EQ(dayOf("2000-03-01"), 60);  // a leap year
  EXPECT_EQ(dayOf("1999-12-31"), -1);
  EXPECT_EQ(dayOf("2100-03-01") - dayOf("2100-02-28"), 1);  // not a leap year
}

TEST(HistoryDate, OfAMonthOrYearIsItsMiddle) {
  EXPECT_NEAR(dayOf("2019-03"), dayOf("2019-03-16"), 1);
  EXPECT_NEAR(dayOf("2019"), dayOf("2019-07-02"), 1);
}

TEST(HistoryDate, MayBeADecimalYear) {
  EXPECT_NEAR(dayOf("2019.5"), dayOf("2019-07-02"), 1.5);
  EXPECT_EQ(dayOf("2019,5"), dayOf("2019.5"));
  EXPECT_EQ(parseHistoryDate("2019.5")->form, HistoryDate::Form::DecimalYear);
  EXPECT_NEAR(asDecimalYear(*parseHistoryDate("2019")).day, dayOf("2019-01-01"), 1);
}

TEST(HistoryDate, IsRefusedWhereItIsNoneOrTwo) {
  for (const char* text : {"", "x", "3/7/2019", "2019-13-01", "2019-02-30", "2019-3-", "19-03-07", "99",
                           "123456", "2019-03/07", "-2019", "0.512"})
    EXPECT_FALSE(parseHistoryDate(text)) << text;
}

}  // namespace
}  // namespace alidade
