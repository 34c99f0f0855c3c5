#include "core/session/time_text.h"

#include <gtest/gtest.h>

namespace alidade::test {
namespace {

TEST(DayText, IsCompletedWhereItCanOnlyBeMeantSo) {
  for (const char* typed :
       {"1.3.2026", "01.03.2026", "1. 3. 2026", "2026/3/1", "2026-3-1", "2026.03.01", "20260301",
        "1 Mar 2026", "1. March 2026", "Mar 1, 2026", "2026-Mar-01", "2026年3月1日", "2026-03-01"})
    EXPECT_EQ(completedDay(typed), "2026-03-01") << typed;
  EXPECT_EQ(completedDay("13/2/2026"), "2026-02-13");
  EXPECT_EQ(completedDay("2-13-2026"), "2026-02-13");
  EXPECT_EQ(completedDay("5/5/2026"), "2026-05-05");
}

TEST(DayText, IsAsTypedElsewhere) {
  for (const char* typed :
       {"", "3/4/2026", "01-03-2026", "1.3.26", "31.2.2026", "1 Foo 2026", "yesterday", "2026", "1.3/2026",
        "12345678", "1 2 3 2026", "2026-03-01 10:30", "99999999999.1.2026"})
    EXPECT_EQ(completedDay(typed), typed);
}

}  // namespace
}  // namespace alidade::test
