#include "core/session/time_text.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

// 2026-03-01 is the 20513th day since 1970-01-01 (date -d 2026-03-01 +%s / 86400).
TEST(Instant, ReadsIso8601) {
  constexpr double day = 20513 * 1440.0;
  EXPECT_EQ(minutesOf("2026-03-01T10:12:30Z"), day + 10 * 60 + 12.5);
  EXPECT_EQ(minutesOf("2026-03-01 10:12"), day + 10 * 60 + 12);
  EXPECT_EQ(minutesOf("2026-03-01T10:12:00+01:00"), day + 9 * 60 + 12);
  EXPECT_EQ(minutesOf("2026-03-01T10:12:00-0530"), day + 15 * 60 + 42);
  EXPECT_EQ(minutesOf("2026-03-01T10:12:00.5+01"), day + 9 * 60 + 12 + 0.5 / 60);
}

TEST(Instant, RefusesWhatIsNone) {
  for (const char* text :
       {"", "noon", "2026-02-30T10:00:00Z", "2026-03-01", "2026-03-01T25:00", "2026-03-01T10:60", "10:12:00",
        "2026-03-01T10:12:00+1", "2026-03-01T10:12:00Zulu", "2026-03-01T1:2:3"})
    EXPECT_FALSE(minutesOf(text)) << text;
}

}  // namespace
}  // namespace alidade
