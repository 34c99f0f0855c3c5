#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/session/instrument_record.h"
#include "core/session/measurement.h"
#include "core/session/session_file.h"
#include "core/session/taken_record.h"

// The offset e of the line of sight from the vertical axis: in a record, in a session, and in the known
// collimation at the session's distance.

namespace alidade {
namespace {

using testing::HasSubstr;

InstrumentRecord recordWithOffset() {
  return {.name = "T-1",
          .date = "2026-03-01",
          .lineOfSight = {"0.117", "0.0025", "-0.7"},
          .known = {{"collimation", "", "8", "0.15", "arcsec", "check"}}};
}

Session sessionAt(const std::string& distance, const std::string& radius) {
  Session session = blankSession();
  session.geometry.distanceMm = distance;
  session.geometry.radiusMm = radius;
  return session;
}

const KnownNumber* collimationOf(const Examined& examined) {
  if (!examined.measurement) return nullptr;
  for (const KnownNumber& known : examined.measurement->known)
    if (known.effect == "collimation") return &known;
  return nullptr;
}

TEST(LineOfSight, AddsToTheKnownCollimationAtTheDistanceOfTheSlider) {
  Session session = sessionAt("2400", "700");  // 7-24-25: the slider is at 2500 mm
  ASSERT_FALSE(takeRecord(session, recordWithOffset(), "t.alidade-instrument"));
  const Examined examined = examine(session);
  const KnownNumber* known = collimationOf(examined);
  ASSERT_TRUE(known);
  const double perMillimetre = 206264.80625 / 2500;
  EXPECT_NEAR(known->value, 8 + 0.117 * perMillimetre, 1e-6) << "17.65″";
  const double u = 0.0025 * perMillimetre;
  EXPECT_NEAR(known->sigma, std::sqrt(0.15 * 0.15 + u * u - 2 * 0.7 * 0.15 * u), 1e-9);
  EXPECT_THAT(known->from, HasSubstr("line of sight off by 0.117 ± 0.0025 mm at 2500 mm added"));
}

TEST(LineOfSight, IsTakenAndReplacedWithItsCollimation) {
  Session session = sessionAt("2400", "700");
  ASSERT_FALSE(takeRecord(session, recordWithOffset(), "t.alidade-instrument"));
  EXPECT_EQ(session.instrument.lineOfSight, recordWithOffset().lineOfSight);
  EXPECT_EQ(*readSession(writeSession(session)), session);
  EXPECT_EQ(recordOf(session).lineOfSight, recordWithOffset().lineOfSight);
  InstrumentRecord old = recordWithOffset();
  old.lineOfSight = {};
  ASSERT_FALSE(takeRecord(session, old, "old.alidade-instrument"));
  EXPECT_EQ(session.instrument.lineOfSight, LineOfSight()) << "its collimation has e/D in it";
  const Examined examined = examine(session);
  ASSERT_TRUE(collimationOf(examined));
  EXPECT_NEAR(collimationOf(examined)->value, 8, 1e-12);
}

TEST(LineOfSight, ThatNoCheckStatedMakesItsCollimationUncertain) {
  Session session = sessionAt("2400", "700");
  InstrumentRecord record = recordWithOffset();
  record.lineOfSight = {};
  record.known.front().from = fromInstrumentCheck;
  ASSERT_FALSE(takeRecord(session, record, "t.alidade-instrument"));
  const Examined examined = examine(session);
  ASSERT_TRUE(collimationOf(examined));
  EXPECT_NEAR(collimationOf(examined)->value, 8, 1e-12);
  EXPECT_NEAR(collimationOf(examined)->sigma, std::hypot(0.15, 0.1 * 206264.80625 / 2500), 1e-9) << "8.25″";
}

TEST(LineOfSight, StandsInARecordByTheNamesOfItsMembers) {
  const std::string text = writeInstrumentRecord(recordWithOffset());
  EXPECT_THAT(text, HasSubstr("\"line_of_sight_mm\": 0.117"));
  EXPECT_THAT(text, HasSubstr("\"sigma_line_of_sight_mm\": 0.0025"));
  EXPECT_THAT(text, HasSubstr("\"line_of_sight_correlation\": -0.7"));
  const Result<InstrumentRecord> read = readInstrumentRecord(text);
  ASSERT_TRUE(read) << read.problem().text();
  EXPECT_EQ(read->lineOfSight, recordWithOffset().lineOfSight);
}

TEST(LineOfSight, OfAnOldRecordIsNotKnown) {
  const Result<InstrumentRecord> read =
      readInstrumentRecord(R"({"format": "alidade-instrument", "version": 1, "date": "2026-03-01"})");
  ASSERT_TRUE(read) << read.problem().text();
  EXPECT_EQ(read->lineOfSight, LineOfSight());
}

TEST(LineOfSight, IsRefusedOutOfRange) {
  for (const char* member : {"\"line_of_sight_mm\": 117", "\"sigma_line_of_sight_mm\": -1",
                             "\"line_of_sight_correlation\": -1.2", "\"line_of_sight_mm\": \"far\""}) {
    const Result<InstrumentRecord> read = readInstrumentRecord(
        std::string(R"({"format": "alidade-instrument", "version": 1, "date": "2026-03-01", )") + member +
        "}");
    EXPECT_FALSE(read) << member;
  }
}

}  // namespace
}  // namespace alidade
