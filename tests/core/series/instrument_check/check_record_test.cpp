#include "core/series/instrument_check/check_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/number_text.h"
#include "tests/core/series/instrument_check/simulated_rounds.h"

namespace alidade::test {
namespace {

const std::vector<Target> steep{{10, 3}, {95, -14}, {200, 40}, {290, 1}};

InstrumentRecord recordOf(const SimulatedInstrument& instrument, const std::vector<Target>& targets) {
  return checkedRecord(checkInstrument(completeRounds(simulatedRounds(instrument, targets, 7, 9))), "T2",
                       "123", "2026-03-14");
}

double number(const std::string& text) {
  return *parseNumber(text);
}

TEST(CheckedRecord, HoldsWhatTheCheckFound) {
  const InstrumentRecord record = recordOf({.collimation = 8, .tilt = 20, .index = -5, .noise = 1}, steep);
  EXPECT_EQ(record.date, "2026-03-14");
  ASSERT_EQ(record.known.size(), 3U);
  const double truths[] = {8, 20, -5};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(number(record.known[i].value), truths[i], 4 * number(record.known[i].sigma))
        << record.known[i].effect;
  // s is of two faces, the record's σ of one reading: 1″, which 18 degrees of freedom tell to 17 %; 3 of it.
  EXPECT_NEAR(number(record.sigmaHorizontalArcsec), 1, 0.5);
  const auto back = readInstrumentRecord(writeInstrumentRecord(record));
  ASSERT_TRUE(back) << back.problem().text();
  EXPECT_EQ(back->known.size(), 3U);
}

TEST(CheckedRecord, LeavesOutWhatTheReadingsDoNotShow) {
  const InstrumentRecord record = recordOf({.noise = 1}, {{10, 1}, {95, 1}, {200, 1}});
  ASSERT_EQ(record.known.size(), 2U);
  EXPECT_EQ(record.known[0].effect, "collimation");
  EXPECT_EQ(record.known[1].effect, "vertical_index");
}

}  // namespace
}  // namespace alidade::test
