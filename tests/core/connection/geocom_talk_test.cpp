#include "core/connection/geocom_talk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/angle_text.h"
#include "tests/core/connection/talk_bench.h"

namespace alidade {
namespace {

using testing::HasSubstr;

const std::string angles = "0,4.353982047,1.454868102,2.4e-6,1000,-9.7e-6,4.8e-6,2.4e-6,1000,0";

/// A conversation with the instrument, from waking it to the question for the angles.
struct GeoComBench {
  GeoComTalk talk;
  TalkBench bench{talk};

  explicit GeoComBench(const TalkCircles& circles = {}) : talk(circles) {}

  void answerLast(const std::string& rest) {
    const auto question = geoComQuestion(bench.takeSent());
    ASSERT_TRUE(question);
    bench.receive("%R1P,0," + std::to_string(*question->transaction) + ":" + rest + "\r\n");
  }
  void wake() {
    bench.keep(talk.begin(0));
    for (const char* rest : {"0", "0", "0,15", "0,\"TS16\"", "0,123456", "0,9,10,1", "0,24"})
      answerLast(rest);
  }
  /// Requests a reading, and states the instrument.
  void take(const std::string& serial = "123456") {
    bench.keep(talk.take(bench.now));
    EXPECT_THAT(bench.sent, HasSubstr("%R1Q,5003,"));
    answerLast("0," + serial);
  }
  /// Continues up to the question for the angles.
  void askForAngles() {
    take();
    EXPECT_THAT(bench.sent, HasSubstr("%R1Q,2014,"));
    answerLast("0,1,1,0,1");
    EXPECT_THAT(bench.sent, HasSubstr("%R1Q,2007,"));
    answerLast("0,1");
    EXPECT_THAT(bench.sent, HasSubstr("%R1Q,2003,"));
  }
};

TEST(GeoComTalk, WakesTheInstrumentAndKnowsIt) {
  GeoComBench geocom;
  geocom.wake();
  EXPECT_EQ(geocom.talk.identity().name, "TS16");
  EXPECT_EQ(geocom.talk.identity().serial, "123456");
  EXPECT_EQ(geocom.talk.identity().software, "9.10.1");
  EXPECT_EQ(geocom.talk.identity().temperatureC, "24");
  EXPECT_TRUE(geocom.bench.takeSent().empty());
  EXPECT_TRUE(geocom.bench.remarks.empty());
  EXPECT_FALSE(geocom.talk.wakeAt());
}

TEST(GeoComTalk, TheFirstQuestionMayBeLost) {
  GeoComBench geocom;
  geocom.bench.keep(geocom.talk.begin(0));
  EXPECT_EQ(geocom.bench.takeSent(), "%R1Q,0,1:\r\n");
  geocom.bench.wait(*geocom.talk.wakeAt());
  EXPECT_EQ(geocom.bench.sent, "%R1Q,0,2:\r\n");
  geocom.answerLast("0");
  EXPECT_EQ(geocom.bench.sent, "%R1Q,0,3:\r\n");
}

TEST(GeoComTalk, WhoDoesNotAnswerIsTold) {
  GeoComBench geocom;
  geocom.bench.keep(geocom.talk.begin(0));
  for (int i = 0; i < 3; ++i) geocom.bench.wait(2000);
  EXPECT_FALSE(geocom.talk.wakeAt());
  ASSERT_EQ(geocom.bench.remarks.size(), 1U);
  EXPECT_THAT(geocom.bench.remarks[0], HasSubstr("failed to answer 3 times"));
}

TEST(GeoComTalk, TakesAReadingWithTiltsAndCorrections) {
  GeoComBench geocom;
  geocom.wake();
  geocom.askForAngles();
  geocom.answerLast(angles);
  ASSERT_EQ(geocom.bench.readings.size(), 1U);
  const InstrumentReading& reading = geocom.bench.readings[0];
  // 4.353982047 rad and 1.454868102 rad, by another calculator.
  EXPECT_NEAR(parseAngle(reading.horizontal)->arcseconds(), 898073.2633, 1e-3);
  EXPECT_NEAR(parseAngle(reading.vertical)->arcseconds(), 300088.0872, 1e-3);
  EXPECT_EQ(reading.face, 1);
  EXPECT_EQ(reading.tiltCrossArcsec, "-2.00");
  EXPECT_EQ(reading.tiltLengthArcsec, "0.99");
  EXPECT_EQ(reading.corrections, "inclination standing_axis tilting_axis");
  EXPECT_FALSE(geocom.talk.isTaking());
}

TEST(GeoComTalk, TakesItWhereverTheBytesAreSplit) {
  const std::string answer = "%R1P,0,3:" + angles + "\r\n";
  for (std::size_t split = 0; split <= answer.size(); ++split) {
    GeoComBench geocom;
    geocom.wake();
    geocom.askForAngles();
    const auto question = geoComQuestion(geocom.bench.takeSent());
    std::string bytes = answer;
    bytes[7] = std::to_string(*question->transaction)[0];
    geocom.bench.receive(bytes.substr(0, split));
    geocom.bench.receive(bytes.substr(split));
    ASSERT_EQ(geocom.bench.readings.size(), 1U) << "split at " << split;
    EXPECT_TRUE(geocom.bench.remarks.empty());
  }
}

TEST(GeoComTalk, TheFaceIsReadFromTheCircle) {
  GeoComBench geocom({.vertical = VerticalCircle::Elevation});
  geocom.wake();
  geocom.askForAngles();
  geocom.answerLast("0,1.0,4.8,0,0,0,0,0,0,0");
  ASSERT_EQ(geocom.bench.readings.size(), 1U);
  EXPECT_EQ(geocom.bench.readings[0].face, 2);
  // 4.8 rad of zenith angle: the elevation circle continues from 90° at the zenith, so 450° − 275.0198°.
  EXPECT_NEAR(parseAngle(geocom.bench.readings[0].vertical)->degrees(), 174.98026, 1e-4);
  EXPECT_TRUE(geocom.bench.said("the circle is used")) << "the instrument said face 1";
}

TEST(GeoComTalk, TiltsOfACompensatorThatIsOffAreNone) {
  GeoComBench geocom;
  geocom.wake();
  geocom.take();
  geocom.answerLast("0,0,0,0,0");
  geocom.answerLast("0,0");
  geocom.answerLast(angles);
  ASSERT_EQ(geocom.bench.readings.size(), 1U);
  EXPECT_EQ(geocom.bench.readings[0].tiltCrossArcsec, "");
  EXPECT_EQ(geocom.bench.readings[0].corrections, "none");
}

TEST(GeoComTalk, WhatIsBusyIsAskedAgainALittleLater) {
  GeoComBench geocom;
  geocom.wake();
  geocom.askForAngles();
  for (int i = 0; i < 5; ++i) {
    geocom.answerLast("1293");
    EXPECT_TRUE(geocom.bench.sent.empty());
    geocom.bench.wait(500);
  }
  geocom.answerLast(angles);
  EXPECT_EQ(geocom.bench.readings.size(), 1U);
  EXPECT_EQ(geocom.bench.remarks.size(), 1U) << "said once";
}

TEST(GeoComTalk, ALateOrDoubleAnswerIsNoSecondReading) {
  GeoComBench geocom;
  geocom.wake();
  geocom.askForAngles();
  const std::string late = "%R1P,0," + std::to_string(*geoComQuestion(geocom.bench.takeSent())->transaction) +
                           ":" + angles + "\r\n";
  geocom.bench.wait(6000);
  geocom.bench.receive(late);
  EXPECT_TRUE(geocom.bench.readings.empty()) << "nobody waits for it any more";
  const std::string good = "%R1P,0," + std::to_string(*geoComQuestion(geocom.bench.takeSent())->transaction) +
                           ":" + angles + "\r\n";
  geocom.bench.receive(good + good);
  geocom.bench.receive(late);
  EXPECT_EQ(geocom.bench.readings.size(), 1U);
  EXPECT_TRUE(geocom.bench.said("late or twice"));
}

TEST(GeoComTalk, ASpoiledAnswerIsAskedForAgainAndNeverTaken) {
  for (const char* spoiled : {"0,4.35,1.45,0,0,0,0,0", "0,4.35,1.4x,0,0,0,0,0,0,0", "0",
                              "0,nan,1,0,0,0,0,0,0,0", "0,1e300,1,0,0,0,0,0,0,0", "0,1,2,3,4,5,6,7,8,9,10"}) {
    GeoComBench geocom;
    geocom.wake();
    geocom.askForAngles();
    geocom.answerLast(spoiled);
    EXPECT_TRUE(geocom.bench.readings.empty()) << spoiled;
    geocom.answerLast(angles);
    EXPECT_EQ(geocom.bench.readings.size(), 1U) << spoiled;
    EXPECT_TRUE(geocom.bench.said("corrupted")) << spoiled;
  }
}

TEST(GeoComTalk, AWrongChecksumIsAskedAgainAndARightOnePasses) {
  GeoComBench geocom;
  geocom.wake();
  geocom.askForAngles();
  const auto answer = [&](int change) {
    const std::string reply =
        "%R1P,0," + std::to_string(*geoComQuestion(geocom.bench.takeSent())->transaction);
    const int sum = geoComChecksum(reply + ":" + angles) ^ change;
    geocom.bench.receive(reply + "," + std::to_string(sum) + ":" + angles + "\r\n");
  };
  answer(1);
  EXPECT_TRUE(geocom.bench.readings.empty());
  EXPECT_TRUE(geocom.bench.said("The check sum of an answer does not match its text"));
  answer(0);
  EXPECT_EQ(geocom.bench.readings.size(), 1U);
}

TEST(GeoComTalk, ChecksumsThatNeverFitEndInASentence) {
  GeoComBench geocom;
  geocom.wake();
  geocom.askForAngles();
  for (int i = 0; i < 3; ++i)
    geocom.bench.receive("%R1P,0," + std::to_string(*geoComQuestion(geocom.bench.takeSent())->transaction) +
                         ",7:" + angles + "\r\n");
  EXPECT_TRUE(geocom.bench.readings.empty());
  EXPECT_TRUE(geocom.bench.said("The answers of the instrument were corrupted 3 times."));
  EXPECT_FALSE(geocom.talk.isTaking());
}

TEST(GeoComTalk, AReadingSaysItsCodeAndWhetherTheInstrumentVouchesForIt) {
  for (const char* code : {"0", "1283", "1284", "1285", "1288", "1289"}) {
    GeoComBench geocom;
    geocom.wake();
    geocom.askForAngles();
    geocom.answerLast(code + angles.substr(1));
    ASSERT_EQ(geocom.bench.readings.size(), 1U) << code;
    const InstrumentReading& reading = geocom.bench.readings[0];
    EXPECT_EQ(reading.returnCode, code);
    const bool isGuaranteed = code == std::string("0") || code == std::string("1285");
    EXPECT_EQ(reading.reservation.empty(), isGuaranteed) << code;
    EXPECT_EQ(reading.serial, "123456");
  }
}

TEST(GeoComTalk, AnotherInstrumentAtTheSameCableIsKnown) {
  GeoComBench geocom;
  geocom.wake();
  geocom.take("654321");
  geocom.answerLast("0,1,1,0,1");
  geocom.answerLast("0,1");
  geocom.answerLast(angles);
  ASSERT_EQ(geocom.bench.readings.size(), 1U);
  EXPECT_EQ(geocom.bench.readings[0].serial, "654321");
  EXPECT_THAT(geocom.bench.sent, HasSubstr("%R1Q,5004,")) << "its name is another one";
  geocom.answerLast("0,\"TM50\"");
  EXPECT_EQ(geocom.talk.identity().name, "TM50");
  EXPECT_EQ(geocom.talk.identity().serial, "654321");
}

TEST(GeoComTalk, ABadCodeEndsInASentenceAndTheNextReadingGoesOn) {
  GeoComBench geocom;
  geocom.wake();
  geocom.askForAngles();
  geocom.answerLast("1290");
  EXPECT_TRUE(geocom.bench.said("No reading was taken"));
  EXPECT_FALSE(geocom.talk.isTaking());
  geocom.askForAngles();
  geocom.answerLast(angles);
  EXPECT_EQ(geocom.bench.readings.size(), 1U);
}

TEST(GeoComTalk, DoesWithoutWhatAnInstrumentDoesNotKnow) {
  GeoComBench geocom;
  geocom.wake();
  geocom.take();
  geocom.answerLast("5");  // 2014
  geocom.answerLast("5");  // 2007
  geocom.answerLast("5");  // 2003
  EXPECT_THAT(geocom.bench.sent, HasSubstr("%R1Q,2107,"));
  geocom.answerLast("0,1.5,1.6");
  ASSERT_EQ(geocom.bench.readings.size(), 1U);
  EXPECT_EQ(geocom.bench.readings[0].corrections, "") << "not told";
  EXPECT_EQ(geocom.bench.readings[0].tiltCrossArcsec, "");
  geocom.take();
  EXPECT_THAT(geocom.bench.sent, HasSubstr("%R1Q,2107,")) << "asked at once the next time";
}

TEST(GeoComTalk, ACableThatIsPulledEndsInASentence) {
  GeoComBench geocom;
  geocom.wake();
  geocom.askForAngles();
  geocom.bench.receive("%R1P,0,1:0,4.3");
  for (int i = 0; i < 60; ++i) geocom.bench.wait(500);
  EXPECT_TRUE(geocom.bench.readings.empty());
  EXPECT_TRUE(geocom.bench.said("Only part of a line came"));
  EXPECT_TRUE(geocom.bench.said("failed to answer 3 times"));
  EXPECT_FALSE(geocom.talk.isTaking());
  EXPECT_FALSE(geocom.talk.wakeAt());
}

TEST(GeoComTalk, AskedTwiceTakesOnce) {
  GeoComBench geocom;
  geocom.wake();
  geocom.askForAngles();
  const std::string question = geocom.bench.sent;
  geocom.bench.keep(geocom.talk.take(0));
  EXPECT_EQ(geocom.bench.sent, question) << "nothing more was asked";
  geocom.answerLast(angles);
  EXPECT_EQ(geocom.bench.readings.size(), 1U);
}

/// Every reading arrives once and in order, with every fault, at full resolution.
TEST(GeoComTalk, TakesTwoFacesWithEveryFault) {
  SimulatedOptions options{.sightings = twoFaceSightings(36), .faultEvery = 3};
  options.faults = {InstrumentFault::Garbage, InstrumentFault::Cut,  InstrumentFault::Silent,
                    InstrumentFault::Twice,   InstrumentFault::Busy, InstrumentFault::WrongChecksum};
  options.hasChecksums = true;
  SimulatedInstrument instrument(options);
  GeoComTalk talk({});
  TalkBench bench{talk};
  bench.keep(talk.begin(0));
  exchange(bench, instrument);
  EXPECT_EQ(talk.identity().serial, "1000001");
  for (std::size_t i = 0; i < options.sightings.size(); ++i) {
    bench.keep(talk.take(bench.now));
    for (int turn = 0; turn < 200 && talk.isTaking(); ++turn) {
      exchange(bench, instrument);
      if (talk.isTaking()) bench.wait(100);
    }
    ASSERT_EQ(bench.readings.size(), i + 1);
    const InstrumentReading& reading = bench.readings.back();
    const SimulatedSighting& sighting = options.sightings[i];
    // The tolerance is half of the last place that is written.
    EXPECT_NEAR(reading.horizontalAngle.arcseconds(), sighting.horizontal.arcseconds(), 5.1e-4) << i;
    EXPECT_NEAR(parseAngle(reading.vertical)->arcseconds(), sighting.zenith.arcseconds(), 5.1e-4) << i;
    EXPECT_EQ(reading.face, i % 2 == 0 ? 1 : 2);
    EXPECT_NEAR(std::stod(reading.tiltCrossArcsec), sighting.tiltCross.arcseconds(), 0.0051);
    EXPECT_EQ(reading.corrections, "inclination standing_axis collimation tilting_axis");
  }
  EXPECT_TRUE(instrument.isDone());
}

}  // namespace
}  // namespace alidade
