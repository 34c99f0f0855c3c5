#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/adjustment/result/session_fit.h"
#include "core/base/angle_text.h"
#include "core/connection/geocom_talk.h"
#include "core/connection/gsi_talk.h"
#include "core/connection/simulated_instrument.h"
#include "core/session/face.h"
#include "core/session/measurement.h"
#include "core/session/row_fields.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/ui/connection/landing_window.h"

// Where readings are stored by a protocol, and which questions come before. A simulated instrument speaks to
// the window's reading flow, with a clock set by hand.

namespace alidade::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

alidade::Protocol planInFull() {
  alidade::Protocol plan = *protocolByName("two-face");
  plan.points = 18;
  plan.first = Angle::fromDegrees(5);
  plan.rounds = 1;
  return plan;
}

/// 18 places in both faces in both positions, each with its zero in both faces before and after: 80
/// sightings.
Session sightedInFull() {
  Truth truth = drawTruth(11);
  truth.sightsZerosInFull = true;
  return *simulate(planInFull(), truth, 11);
}

/// The same session without readings, and a protocol for all of them.
Session plannedInFull(Session session) {
  SightingProtocol protocol = templateOf(planInFull());
  for (ProtocolPosition& position : protocol.positions) position.zeros.before = position.zeros.after = {1, 2};
  session.protocol = protocolText(protocol);
  session.instrument.serial = "1000001";
  for (Position& position : session.positions) {
    position.zero = {};
    position.readings.clear();
  }
  return session;
}

void expectAngle(const std::string& is, const std::string& was, double within, const std::string& where) {
  const auto a = parseAngle(is), b = parseAngle(was);
  ASSERT_TRUE(a) << where << ": " << is;
  EXPECT_NEAR(wrapped(*a - *b).arcseconds(), 0, within) << where;
}

void expectZero(const ZeroSighting& is, const ZeroSighting& was, double within, const std::string& where) {
  expectAngle(is.horizontal, was.horizontal, within, where);
  expectAngle(is.vertical, was.vertical, within, where);
  EXPECT_THAT(is.takenAt, Not(IsEmpty())) << where;
}

/// Compares each cell with the sent value, to `within` arcseconds, and with its time.
void expectSameCells(const Session& read, const Session& sent, double within) {
  for (std::size_t p = 0; p < sent.positions.size(); ++p) {
    const std::string position = "position " + std::to_string(p);
    const PointingZero &zero = read.positions[p].zero, &sentZero = sent.positions[p].zero;
    expectZero(firstSighting(zero), firstSighting(sentZero), within, position + " zero");
    for (const ZeroSlot& slot : furtherZeros)
      expectZero(zero.*slot.sighting, sentZero.*slot.sighting, within, position + " zero " + slot.key);
    ASSERT_EQ(read.positions[p].readings.size(), sent.positions[p].readings.size()) << position;
    for (std::size_t i = 0; i < sent.positions[p].readings.size(); ++i) {
      const Reading &is = read.positions[p].readings[i], &was = sent.positions[p].readings[i];
      const std::string where = position + " row " + std::to_string(i);
      expectAngle(is.horizontal, was.horizontal, within, where);
      expectAngle(is.vertical, was.vertical, within, where);
      EXPECT_EQ(is.point, was.point) << where;
      EXPECT_EQ(*wholeEntry(faceRule, is.face), *wholeEntry(faceRule, was.face)) << where;
      EXPECT_THAT(is.takenAt, Not(IsEmpty())) << where;
      EXPECT_EQ(is.instrumentSerial, "1000001") << where;
    }
  }
}

/// The instrument and its connection.
struct Cable {
  SimulatedInstrument instrument;
  InstrumentTalk& talk;
  Milliseconds now = 0;
  std::vector<InstrumentReading> readings = {};

  void follow(TalkStep step) {
    while (true) {
      readings.insert(readings.end(), step.readings.begin(), step.readings.end());
      if (step.toSend.empty()) return;
      const std::string sent = instrument.receive(step.toSend);
      if (sent.empty()) return;
      step = talk.receive(sent, now);
    }
  }
  void wait(Milliseconds time) {
    now += time;
    follow(talk.tick(now));
    const std::string again = instrument.tick(now);
    if (!again.empty()) follow(talk.receive(again, now));
  }
};

struct CableRun {
  std::vector<std::string> ofFaults;  ///< questions about wrong readings
  std::vector<std::string> ofSound;   ///< questions about correct readings
  std::size_t unasked = 0;            ///< wrong readings stored without a question
};

/// Accepts a correct reading and discards a wrong one, if the window asks about it.
void answer(LandingWindow& window, const InstrumentReading& reading, bool isRight, CableRun& run) {
  const std::string question = window.add(reading);
  if (question.empty()) {
    run.unasked += isRight ? 0 : 1;
    return;
  }
  (isRight ? run.ofSound : run.ofFaults).push_back(question);
  if (isRight)
    window.take();
  else
    window.flow().discard();
}

CableRun readByGeoCom(LandingWindow& window, Cable& cable) {
  CableRun run;
  cable.follow(cable.talk.begin(cable.now));
  for (int turn = 0; turn < 400 && !cable.instrument.isDone(); ++turn) {
    const std::size_t before = cable.instrument.delivered();
    cable.readings.clear();
    cable.follow(cable.talk.take(cable.now));
    for (int i = 0; i < 200 && cable.talk.isTaking(); ++i) cable.wait(100);
    for (const InstrumentReading& reading : cable.readings)
      answer(window, reading, cable.instrument.delivered() > before, run);
  }
  return run;
}

CableRun readByGsi(LandingWindow& window, Cable& cable) {
  CableRun run;
  cable.follow(cable.talk.begin(cable.now));
  for (int turn = 0; turn < 400 && !cable.instrument.isDone(); ++turn) {
    const std::size_t before = cable.instrument.delivered();
    cable.readings.clear();
    const std::string sent = cable.instrument.record(cable.now);
    if (!sent.empty()) cable.follow(cable.talk.receive(sent, cable.now));
    for (int i = 0; i < 60; ++i) cable.wait(500);  // half a minute: no block counts as repeated
    for (const InstrumentReading& reading : cable.readings)
      answer(window, reading, cable.instrument.delivered() > before, run);
  }
  return run;
}

const std::vector<InstrumentFault> everyInstrumentFault = {
    InstrumentFault::Garbage,       InstrumentFault::Cut,         InstrumentFault::Silent,
    InstrumentFault::Twice,         InstrumentFault::Busy,        InstrumentFault::Wrong,
    InstrumentFault::OtherFace,     InstrumentFault::Turned,      InstrumentFault::Again,
    InstrumentFault::NotGuaranteed, InstrumentFault::OtherSerial, InstrumentFault::WrongChecksum};

std::size_t questionsAbout(const std::vector<std::string>& questions, const char* part) {
  return static_cast<std::size_t>(std::ranges::count_if(
      questions, [part](const std::string& one) { return one.find(part) != std::string::npos; }));
}

/// `faultEvery` 3: each fault twice, at sightings 3, 6, … 72 of 80.
SimulatedOptions optionsOf(const Session& sent, InstrumentProtocol protocol) {
  SimulatedOptions options{.protocol = protocol, .sightings = sightingsOf(sent), .faultEvery = 3};
  options.faults = everyInstrumentFault;
  options.hasChecksums = protocol == InstrumentProtocol::GeoCom;
  if (!options.hasChecksums) std::erase(options.faults, InstrumentFault::WrongChecksum);
  return options;
}

TEST(ProtocolLanding, EverySightingByGeoComLandsWhereTheProtocolAsksForItWithEveryFault) {
  const Session sent = sightedInFull();
  ASSERT_EQ(sightingsOf(sent).size(), 80U);
  LandingWindow window(plannedInFull(sent));
  GeoComTalk talk({});
  Cable cable{SimulatedInstrument(optionsOf(sent, InstrumentProtocol::GeoCom)), talk};
  const CableRun run = readByGeoCom(window, cable);
  expectSameCells(window.session(), sent, 5.1e-4);  // half of the last written digit
  EXPECT_EQ(run.unasked, 0U);
  ASSERT_EQ(run.ofSound.size(), 1U) << "of the first sighting at 180°";
  EXPECT_THAT(run.ofSound[0],
              AllOf(HasSubstr("180°: pointing zero"), HasSubstr("has the axis been turned?")));
  for (const char* part : {"is asked for", "did the instrument send them again?", "Return code 128",
                           "serial number 2000002", "is it the right target?"})
    EXPECT_GE(questionsAbout(run.ofFaults, part), 2U) << part;
  for (const Position& position : window.session().positions) {
    EXPECT_EQ(position.zero.returnCode, "0");
    EXPECT_EQ(position.zero.afterInTwo.instrumentSerial, "1000001");
    for (const Reading& row : position.readings) EXPECT_EQ(row.returnCode, "0");
  }
}

TEST(ProtocolLanding, EverySightingByGsiLandsWhereTheProtocolAsksForItWithEveryFault) {
  const Session sent = sightedInFull();
  LandingWindow window(plannedInFull(sent));
  GsiTalk talk({});
  Cable cable{SimulatedInstrument(optionsOf(sent, InstrumentProtocol::Gsi)), talk};
  const CableRun run = readByGsi(window, cable);
  expectSameCells(window.session(), sent, 0.051);  // half of a tenth of a second
  EXPECT_EQ(run.unasked, 0U);
  EXPECT_EQ(run.ofSound.size(), 1U);
  for (const char* part : {"is asked for", "did the instrument send them again?", "was keyed in",
                           "serial number 2000002", "is it the right target?"})
    EXPECT_GE(questionsAbout(run.ofFaults, part), 2U) << part;
  for (const Position& position : window.session().positions)
    for (const Reading& row : position.readings) {
      EXPECT_EQ(row.returnCode, "") << "GSI has none";
      EXPECT_EQ(row.corrections, "inclination standing_axis collimation tilting_axis");
    }
}

double intersectionOf(const Session& session) {
  const Examined examined = examine(session);
  return fitSession(*examined.measurement).intersection->value;
}

// The tripod is knocked by 30″ between the positions: the zero of 180° is sighted again, so the result is
// unaffected.
TEST(ProtocolLanding, AZeroAfterTheReadingsIsNotThatOfTheNextPosition) {
  Session sent = sightedInFull();
  const double before = intersectionOf(sent);
  const auto knocked = [](std::string& vertical) {
    vertical = formatDms(
        *parseAngle(vertical) +
            Angle::fromArcseconds(isFaceTwo(*parseAngle(vertical), VerticalCircle::Zenith) ? -30 : 30),
        2);
  };
  Position& turned = sent.positions[1];
  knocked(turned.zero.vertical);
  for (const ZeroSlot& slot : furtherZeros) knocked((turned.zero.*slot.sighting).vertical);
  for (Reading& row : turned.readings) knocked(row.vertical);
  // A circle that counts from 30″ off the plumb line bends the arc by 30″ · x²/2L²: 0.4″ at its ends.
  EXPECT_NEAR(intersectionOf(sent), before, 0.01);
  Session misplaced = sent;  // as read with one zero per position
  misplaced.positions[1].zero = {sent.positions[0].zero.after.horizontal,
                                 sent.positions[0].zero.after.vertical};
  misplaced.positions[0].zero = {sent.positions[0].zero.horizontal, sent.positions[0].zero.vertical};
  EXPECT_GT(std::abs(intersectionOf(misplaced) - before), 0.1);
  RecordProperty("intersection_um", static_cast<int>(1000 * before));
  RecordProperty("misplaced_um", static_cast<int>(1000 * intersectionOf(misplaced)));
  LandingWindow window(plannedInFull(sent));
  SimulatedOptions options{.sightings = sightingsOf(sent)};
  GeoComTalk talk({});
  Cable cable{SimulatedInstrument(options), talk};
  const CableRun run = readByGeoCom(window, cable);
  expectSameCells(window.session(), sent, 5.1e-4);
  EXPECT_NEAR(intersectionOf(window.session()), intersectionOf(sent), 1e-3);
}

}  // namespace
}  // namespace alidade::ui
