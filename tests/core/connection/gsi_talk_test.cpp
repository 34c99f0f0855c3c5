#include "core/connection/gsi_talk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/angle_text.h"
#include "tests/core/connection/talk_bench.h"

namespace alidade {
namespace {

using testing::HasSubstr;

const std::string wide = "*11....+00000000000P0001 21.324+0000000024943030 22.324+0000000008336237";
const std::string narrow = "110001+00000001 21.102+17920860 22.102+10012345 ";

struct GsiBench {
  GsiTalk talk{TalkCircles()};
  TalkBench bench{talk};
};

TEST(GsiTalk, TakesAPushedBlockAndAcknowledgesIt) {
  GsiBench gsi;
  gsi.bench.receive(wide + "\r\n");
  EXPECT_EQ(gsi.bench.takeSent(), "?\r\n");
  ASSERT_EQ(gsi.bench.readings.size(), 1U);
  EXPECT_EQ(gsi.bench.readings[0].horizontal, "249°43'03.0\"");
  EXPECT_EQ(gsi.bench.readings[0].vertical, "83°36'23.7\"");
  EXPECT_EQ(gsi.bench.readings[0].face, 1);
  EXPECT_EQ(gsi.bench.readings[0].point, "P0001");
}

TEST(GsiTalk, TakesBlocksOfEitherWidthWithEitherEndWhereverTheyAreSplit) {
  for (const char* end : {"\r\n", "\r"}) {
    const std::string bytes = wide + end + narrow + end;
    for (std::size_t split = 0; split <= bytes.size(); ++split) {
      GsiBench gsi;
      gsi.bench.receive(bytes.substr(0, split));
      gsi.bench.receive(bytes.substr(split));
      ASSERT_EQ(gsi.bench.readings.size(), 2U) << "split at " << split;
      EXPECT_EQ(gsi.bench.readings[1].horizontal, "179.20860gon");
      EXPECT_EQ(gsi.bench.readings[1].vertical, "100.12345gon");
      EXPECT_EQ(gsi.bench.takeSent(), "?\r\n?\r\n");
      EXPECT_TRUE(gsi.bench.remarks.empty());
    }
  }
}

TEST(GsiTalk, ABlockThatComesAgainIsAcknowledgedAgainAndTakenOnce) {
  GsiBench gsi;
  for (int i = 0; i < 3; ++i) {
    gsi.bench.receive(wide + "\r\n");
    gsi.bench.wait(3000);
  }
  EXPECT_EQ(gsi.bench.takeSent(), "?\r\n?\r\n?\r\n");
  EXPECT_EQ(gsi.bench.readings.size(), 1U);
  EXPECT_TRUE(gsi.bench.said("used once"));
  gsi.bench.wait(30000);
  gsi.bench.receive(wide + "\r\n");
  EXPECT_EQ(gsi.bench.readings.size(), 2U) << "half a minute later it is another sighting";
}

TEST(GsiTalk, ASpoiledBlockIsNotAcknowledgedSoThatItComesAgain) {
  for (const std::string& spoiled :
       {wide.substr(0, 60), wide.substr(0, 49),
        std::string("*11....+0000000000000001 21.324+00000000249430x0 22.324+0000000008336237"),
        std::string("21.324+24943030 22.32A+08336237"), std::string("21.324+99943030 22.324+08336237"),
        std::string("11....+00000001 81..00+00000001")}) {
    GsiBench gsi;
    gsi.bench.receive(spoiled + "\r\n");
    EXPECT_TRUE(gsi.bench.takeSent().empty()) << spoiled;
    EXPECT_TRUE(gsi.bench.readings.empty()) << spoiled;
    EXPECT_EQ(gsi.bench.remarks.size(), 1U) << spoiled;
    gsi.bench.receive(wide + "\r\n");
    EXPECT_EQ(gsi.bench.readings.size(), 1U);
  }
}

TEST(GsiTalk, HalfABlockBeforeTheWholeOneIsPassedOver) {
  GsiBench gsi;
  gsi.bench.receive(wide.substr(0, 40));
  gsi.bench.receive(wide + "\r\n");
  EXPECT_EQ(gsi.bench.readings.size(), 1U);
}

TEST(GsiTalk, AsksForAReadingAndDoesNotAcknowledgeTheAnswer) {
  GsiBench gsi;
  for (int i = 1; i <= 2; ++i) {
    gsi.bench.keep(gsi.talk.take(gsi.bench.now));
    EXPECT_EQ(gsi.bench.takeSent(), "GET/M/WI21/WI22\r\n");
    gsi.bench.receive("21.324+24943030 22.324+27623370 \r\n");
    EXPECT_TRUE(gsi.bench.takeSent().empty());
    EXPECT_EQ(gsi.bench.readings.size(), static_cast<std::size_t>(i)) << "asked for twice, taken twice";
  }
  EXPECT_EQ(gsi.bench.readings[0].face, 2);
}

TEST(GsiTalk, AsksForTheSerialNumberOnce) {
  for (const char* answer : {"12....+00640054 \r\n", "*12....+0000000000640054 \r\n"}) {
    GsiBench gsi;
    gsi.bench.keep(gsi.talk.begin(0));
    EXPECT_EQ(gsi.bench.takeSent(), "GET/I/WI12\r\n");
    gsi.bench.receive(answer);
    EXPECT_EQ(gsi.talk.identity().serial, "640054");
    EXPECT_TRUE(gsi.bench.takeSent().empty()) << "an answer is not acknowledged";
    gsi.bench.receive(wide + "\r\n");
    ASSERT_EQ(gsi.bench.readings.size(), 1U);
    EXPECT_EQ(gsi.bench.readings[0].serial, "640054");
    EXPECT_TRUE(gsi.bench.remarks.empty());
  }
}

TEST(GsiTalk, WhoDoesNotTellItsSerialNumberHasNone) {
  GsiBench gsi;
  gsi.bench.keep(gsi.talk.begin(0));
  gsi.bench.receive("@W127\r\n");
  EXPECT_TRUE(gsi.bench.remarks.empty()) << "nobody asked the instrument for more than it knows";
  gsi.bench.receive(wide + "\r\n");
  EXPECT_EQ(gsi.bench.readings.at(0).serial, "");
  gsi.bench.receive("@W127\r\n");
  EXPECT_TRUE(gsi.bench.said("@W127"));
}

TEST(GsiTalk, ABlockMayHoldTheSerialNumber) {
  GsiBench gsi;
  gsi.bench.receive("110001+00000001 12....+00640054 21.102+17920860 22.102+10012345 \r\n");
  EXPECT_EQ(gsi.bench.readings.at(0).serial, "640054");
}

// Digits according to the GSI ONLINE manual: position 4 states the compensator, position 5 the input.
TEST(GsiTalk, ReadsWhatTheDigitsSayOfCompensatorAndCorrections) {
  struct Case {
    const char *horizontal, *vertical, *corrections;
    std::optional<bool> isCompensated;
    bool isGuaranteed;
  };
  const Case cases[] = {
      {"21.324", "22.324", "inclination standing_axis collimation tilting_axis", true, true},
      {"21.124", "22.124", "inclination standing_axis collimation tilting_axis", true, true},
      {"21.334", "22.334", "inclination", true, true},
      {"21.024", "22.024", "collimation tilting_axis", false, true},
      {"21.034", "22.034", "none", false, true},
      {"21.304", "22.304", "", true, true},
      {"21...4", "22...4", "", std::nullopt, true},
      {"21.314", "22.324", "", true, false},
      {"21.324", "22.344", "inclination standing_axis collimation tilting_axis", true, false}};
  for (const Case& one : cases) {
    const std::string block =
        std::string(one.horizontal) + "+24943030 " + one.vertical + "+08336237 32...0+00021324 ";
    const auto reading = gsiReading(block, VerticalCircle::Zenith);
    ASSERT_TRUE(reading) << block;
    EXPECT_EQ(reading->corrections, one.corrections) << block;
    EXPECT_EQ(reading->isCompensated, one.isCompensated) << block;
    EXPECT_EQ(reading->reservation.empty(), one.isGuaranteed) << block;
    EXPECT_EQ(reading->returnCode, "") << block;
  }
}

TEST(GsiTalk, NoAnswerAndErrorsAreSentences) {
  GsiBench gsi;
  gsi.bench.keep(gsi.talk.take(0));
  gsi.bench.wait(*gsi.talk.wakeAt());
  EXPECT_TRUE(gsi.bench.said("did not answer"));
  EXPECT_FALSE(gsi.talk.isTaking());
  gsi.bench.keep(gsi.talk.take(gsi.bench.now));
  gsi.bench.receive("@W127\r\n");
  EXPECT_TRUE(gsi.bench.said("@W127"));
  EXPECT_FALSE(gsi.talk.isTaking());
  gsi.bench.receive("@E158\r\n");
  EXPECT_TRUE(gsi.bench.said("@E158"));
  gsi.bench.receive("?\r\n");
  gsi.bench.receive("hello\x07\r\n");
  EXPECT_TRUE(gsi.bench.said("hello<07>"));
  EXPECT_TRUE(gsi.bench.readings.empty());
}

/// Every reading arrives once and in order, with every fault, in either width and every unit.
TEST(GsiTalk, TakesTwoFacesWithEveryFault) {
  for (const bool isWide : {true, false}) {
    for (const char unit : {'2', '3', '4'}) {
      SimulatedOptions options{
          .protocol = InstrumentProtocol::Gsi, .sightings = twoFaceSightings(36), .faultEvery = 3};
      options.faults = {InstrumentFault::Garbage, InstrumentFault::Cut, InstrumentFault::Silent,
                        InstrumentFault::Twice, InstrumentFault::Busy};
      options.isWide = isWide;
      options.gsiUnit = unit;
      SimulatedInstrument instrument(options);
      GsiTalk talk({});
      TalkBench bench{talk};
      for (int turn = 0; turn < 5000 && !instrument.isDone(); ++turn) {
        bench.receive(instrument.record(bench.now));
        exchange(bench, instrument);
        bench.wait(300);
        bench.receive(instrument.tick(bench.now));
        exchange(bench, instrument);
      }
      ASSERT_EQ(bench.readings.size(), options.sightings.size()) << isWide << unit;
      for (std::size_t i = 0; i < options.sightings.size(); ++i) {
        // The tolerance is half of the last place: 0.1″, 10⁻⁵ gon, 10⁻⁵ degrees.
        const double half = unit == '4' ? 0.0501 : unit == '2' ? 0.0163 : 0.0181;
        EXPECT_NEAR(parseAngle(bench.readings[i].horizontal)->arcseconds(),
                    options.sightings[i].horizontal.arcseconds(), half);
        EXPECT_NEAR(parseAngle(bench.readings[i].vertical)->arcseconds(),
                    options.sightings[i].zenith.arcseconds(), half);
        EXPECT_EQ(bench.readings[i].face, i % 2 == 0 ? 1 : 2);
      }
    }
  }
}

}  // namespace
}  // namespace alidade
