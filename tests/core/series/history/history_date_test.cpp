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

std::vector<std::string> labels(const char* from, const char* to, std::size_t most) {
  std::vector<std::string> names;
  for (const DateTick& tick : dateTicks(parseHistoryDate(from)->day, parseHistoryDate(to)->day, most)) {
    names.push_back(tick.label);
    const std::string rest = std::string("-01-01").substr(tick.label.size() == 4 ? 0 : 3);
    EXPECT_EQ(parseHistoryDate(tick.label.size() == 10 ? tick.label : tick.label + rest)->day, tick.day);
  }
  EXPECT_LE(names.size(), most);
  return names;
}

TEST(DateTicks, AreRoundDatesOfTheCalendar) {
  using testing::ElementsAre;
  EXPECT_THAT(labels("2025-01-04", "2025-12-15", 4), ElementsAre("2025-04", "2025-07", "2025-10"));
  EXPECT_THAT(labels("2024-02-27", "2024-03-02", 5),
              ElementsAre("2024-02-27", "2024-02-28", "2024-02-29", "2024-03-01", "2024-03-02"));
  EXPECT_THAT(labels("2019-06-01", "2024-05-01", 6), ElementsAre("2020", "2021", "2022", "2023", "2024"));
  EXPECT_THAT(labels("1998-12-31", "2001-01-01", 3), ElementsAre("1999", "2000", "2001"));
  EXPECT_THAT(labels("1900-01-01", "2020-01-01", 4), ElementsAre("1900", "1950", "2000"));
  EXPECT_THAT(labels("2025-03-07", "2025-03-07", 3), ElementsAre("2025-03-07"));
}

TEST(DateTicks, NeverExceedTheirNumber) {
  for (const char* to : {"2000-01-02", "2000-02-02", "2001-02-02", "2010-01-01", "2199-01-01"})
    for (const std::size_t most : {1U, 2U, 5U, 40U}) labels("2000-01-01", to, most);
}

}  // namespace
}  // namespace alidade
