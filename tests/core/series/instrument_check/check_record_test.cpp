#include "core/series/instrument_check/check_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/core/series/instrument_check/simulated_rounds.h"

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<Target> steep{{10, 3}, {95, -14}, {200, 40}, {290, 1}};

Json recordOf(const SimulatedInstrument& instrument, const std::vector<Target>& targets) {
  return Json::parse(writeInstrumentRecord(
      checkedRecord(checkInstrument(completeRounds(simulatedRounds(instrument, targets, 7, 9))),
                    {"T2", "123", "2026-03-14", "2027-03-14"})));
}

TEST(CheckedRecord, HoldsWhatTheCheckFound) {
  const Json record = recordOf({.collimation = 8, .tilt = 20, .index = -5, .noise = 1}, steep);
  EXPECT_EQ(record["format"], "alidade-instrument");
  EXPECT_EQ(record["version"], 1);
  EXPECT_EQ(record["date"], "2026-03-14");
  ASSERT_EQ(record["known"].size(), 3U);
  const double truths[] = {8, 20, -5};
  for (std::size_t i = 0; i < 3; ++i) {
    const Json& known = record["known"][i];
    const double value = known["value"], sigma = known["sigma"];
    EXPECT_NEAR(value, truths[i], 4 * sigma) << known["effect"];
    EXPECT_EQ(known["unit"], "arcsec");
  }
  // s is for two faces, the record's σ for one reading: 1″. 18 degrees of freedom determine it to 17 %; the
  // tolerance is three times that.
  EXPECT_NEAR(record["sigma_horizontal_arcsec"], 1, 0.5);
}

TEST(CheckedRecord, IsTakenAsItIs) {
  const InstrumentRecord record = checkedRecord(
      checkInstrument(completeRounds(simulatedRounds({.collimation = 8, .noise = 1}, steep, 7, 9))),
      {"T2", "123", "2026-03-14", "2027-03-14"});
  const Result<InstrumentRecord> read = readInstrumentRecord(writeInstrumentRecord(record));
  ASSERT_TRUE(read) << read.problem().text();
  EXPECT_EQ(read->known.size(), record.known.size());
  EXPECT_EQ(read->sigmaHorizontalArcsec, record.sigmaHorizontalArcsec);
}

TEST(CheckedRecord, LeavesOutWhatTheReadingsDoNotShow) {
  const Json record = recordOf({.noise = 1}, {{10, 1}, {95, 1}, {200, 1}});
  ASSERT_EQ(record["known"].size(), 2U);
  EXPECT_EQ(record["known"][0]["effect"], "collimation");
  EXPECT_EQ(record["known"][1]["effect"], "vertical_index");
}

}  // namespace
}  // namespace alidade::test
