#include "core/session/taken_record.h"

#include <gtest/gtest.h>

#include "core/session/session_file.h"

namespace alidade {
namespace {

InstrumentRecord recordOfT1() {
  return {.name = "T-1",
          .serial = "4711",
          .date = "2026-03-01",
          .sigmaHorizontalArcsec = "1",
          .sigmaVerticalArcsec = "1.5",
          .known = {{"collimation", "", "3.2", "0.5", "arcsec", "check", "2026-02-27"},
                    {"vertical_index", "", "", "1", "arcsec"}}};
}

TEST(TakenRecord, StandsInTheSessionWithItsSource) {
  Session session = blankSession();
  ASSERT_FALSE(takeRecord(session, recordOfT1(), "t-1.alidade-instrument"));
  const Instrument& own = session.instrument;
  EXPECT_EQ(own.name, "T-1");
  EXPECT_EQ(own.serial, "4711");
  EXPECT_EQ(own.sigmaHorizontalArcsec, "1");
  EXPECT_EQ(own.sigmaVerticalArcsec, "1.5");
  EXPECT_EQ(own.sigmaZeroArcsec, blankSession().instrument.sigmaZeroArcsec) << "the record does not state it";
  EXPECT_EQ(own.record, (NamedRecord{"t-1.alidade-instrument", "2026-03-01"}));
  EXPECT_EQ(own.known, (std::vector<KnownSize>{
                           {"collimation", "", "3.2", "0.5", "arcsec",
                            "instrument record t-1.alidade-instrument of 2026-03-01: check", "2026-02-27"},
                           {"vertical_index", "", "", "1", "arcsec",
                            "instrument record t-1.alidade-instrument of 2026-03-01", "2026-03-01"}}));
  EXPECT_EQ(*readSession(writeSession(session)), session);
}

TEST(TakenRecord, ReplacesWhatWasKnownOfTheSameNumberAndFromAnotherRecord) {
  Session session = blankSession();
  session.instrument.known = {{"collimation", "", "9", "2", "arcsec", "typed"},
                              {"trunnion_tilt", "", "1", "1", "arcsec", "typed"}};
  InstrumentRecord old = recordOfT1();
  old.date = "2025-01-01";
  old.known.push_back({"horizontal_drift", "", "", "1", "arcsec"});
  ASSERT_FALSE(takeRecord(session, old, "old.alidade-instrument"));
  ASSERT_EQ(session.instrument.known.size(), 4u);
  ASSERT_FALSE(takeRecord(session, recordOfT1(), "new.alidade-instrument"));
  ASSERT_EQ(session.instrument.known.size(), 3u);
  EXPECT_EQ(session.instrument.known[0].effect, "trunnion_tilt");
  EXPECT_EQ(session.instrument.known[1].effect, "collimation");
  EXPECT_EQ(session.instrument.known[1].from,
            "instrument record new.alidade-instrument of 2026-03-01: check");
}

// The index of a zenith circle is the negative one of an elevation circle that counts the other way.
TEST(TakenRecord, IsConvertedToTheCircleOfTheSession) {
  InstrumentRecord record = recordOfT1();
  record.known = {{"vertical_index", "", "30", "0.5", "arcsec"}};
  const auto taken = [&](const char* ofRecord, const char* ofSession) {
    record.verticalCircle = ofRecord;
    Session session = blankSession();
    session.geometry.verticalCircle = ofSession;
    EXPECT_FALSE(takeRecord(session, record, "r"));
    return session.instrument.known.at(0).value;
  };
  EXPECT_EQ(taken("zenith", ""), "30");
  EXPECT_EQ(taken("zenith", "elevation"), "-30");
  EXPECT_EQ(taken("elevation", "zenith"), "-30");
  EXPECT_EQ(taken("elevation", "elevation"), "30");
  EXPECT_EQ(taken("", "elevation"), "30") << "an old record does not state its circle";
  Session session = blankSession();
  session.geometry.verticalCircle = "elevation";
  EXPECT_EQ(recordOf(session).verticalCircle, "elevation");
}

TEST(TakenRecord, KeepsBothOfTwoEntriesOfOneNumber) {
  InstrumentRecord record = recordOfT1();
  record.known = {{"collimation", "", "3", "1", "arcsec"}, {"collimation", "", "4", "1", "arcsec"}};
  Session session = blankSession();
  ASSERT_FALSE(takeRecord(session, record, "r"));
  EXPECT_EQ(session.instrument.known.size(), 2u);
}

TEST(TakenRecord, KeepsWhatTheSessionSaysOfTheInstrument) {
  Session session = blankSession();
  session.instrument.name = "mine";
  session.instrument.serial = "4711";
  ASSERT_FALSE(takeRecord(session, recordOfT1(), "r"));
  EXPECT_EQ(session.instrument.name, "mine");
}

TEST(TakenRecord, IsRefusedOfAnotherInstrument) {
  Session session = blankSession();
  session.instrument.serial = "4712";
  const Session before = session;
  const auto problem = takeRecord(session, recordOfT1(), "r");
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->text(),
            "instrument.serial: “4712” is not the serial number in the instrument record (“4711”): choose "
            "the record of this instrument, or correct the serial number");
  EXPECT_EQ(session, before);
}

TEST(TakenRecord, ComesOutAgainAsItWentIn) {
  InstrumentRecord record = recordOfT1();
  Session session = blankSession();
  ASSERT_FALSE(takeRecord(session, record, "r"));
  record.sigmaZeroArcsec = session.instrument.sigmaZeroArcsec;
  record.known[1].date = record.date;
  record.verticalCircle = "zenith";
  EXPECT_EQ(recordOf(session), record);
}

TEST(TakenRecord, IsOfTheDayOfTheMeasurementWhereTheSessionNamesNone) {
  Session session = blankSession();
  session.measuredOn = "2026-05-02";
  session.instrument.known = {{"collimation", "", "9", "2", "arcsec", "typed"}};
  const InstrumentRecord record = recordOf(session);
  EXPECT_EQ(record.date, "2026-05-02");
  EXPECT_EQ(record.known, session.instrument.known);
}

}  // namespace
}  // namespace alidade
