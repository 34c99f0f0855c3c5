#include "core/simulation/compensator_use.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/diagnosis/diagnose.h"
#include "core/effects/cause_ids.h"
#include "core/effects/known_sizes.h"
#include "core/session/measurement.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const Angle ofCompensator = Angle::fromArcseconds(1);

/// A truth with a vertical axis tilted by 200″ about x and −200″ about z.
Truth tiltedTruth(std::uint64_t seed) {
  Truth truth = drawTruth(seed);
  truth.effects = {{ErrorTerm::VerticalAxisTiltX, 200}, {ErrorTerm::VerticalAxisTiltZ, -200}};
  return truth;
}

Session sessionOf(const Truth& truth, std::uint64_t seed, const char* protocol = "paper") {
  const Result<Session> session = simulate(*protocolByName(protocol), truth, seed);
  EXPECT_TRUE(session);
  return *session;
}

Diagnosis diagnosisOf(const Session& session, const DiagnosisOptions& options = {}) {
  const Examined examined = examine(session);
  const auto diagnosis = diagnose(*examined.measurement, options);
  EXPECT_TRUE(diagnosis);
  return *diagnosis;
}

// The axis is tilted backwards by 200″ and to the right by 200″; in face 2 the compensator is rotated by half
// a turn.
TEST(CompensatorUse, StatesTheTiltsOfTheTruth) {
  const Truth truth = tiltedTruth(1);
  Session session = sessionOf(truth, 1, "full");
  stateCompensator(session, truth, CompensatorUse::Measured, Angle::fromArcseconds(1e-3), 1);
  for (const Position& position : session.positions)
    for (const Reading& row : position.readings) {
      const double side = row.face == "2" ? -1 : 1;
      // The places are within 10° of straight ahead: 200″ sin 10° = 35″, and 200″ (1 − cos 10°) = 3″.
      EXPECT_NEAR(std::stod(row.tiltCrossArcsec), side * 200, 38);
      EXPECT_NEAR(std::stod(row.tiltLengthArcsec), side * -200, 38);
      EXPECT_EQ(row.corrections, "none");
    }
}

TEST(CompensatorUse, OffStatesNoTilts) {
  Session session = sessionOf(tiltedTruth(1), 1);
  stateCompensator(session, tiltedTruth(1), CompensatorUse::Off, ofCompensator, 1);
  EXPECT_EQ(session.positions[0].readings[0].tiltCrossArcsec, "");
  EXPECT_EQ(session.positions[0].readings[0].corrections, "none");
  EXPECT_THAT(examine(session).measurement->known, IsEmpty());
}

TEST(CompensatorUse, OnTakesTheTiltOffTheReadings) {
  const Truth left = leftByCompensator(tiltedTruth(1), ofCompensator, 1);
  for (const TrueSize& size : left.effects) EXPECT_LT(std::abs(size.value), 5) << "5 σ";
}

// The known tilts differ from the truth as their σ says: 2 × 60 numbers, the rms over σ within 25 % of 1 (4
// σ).
TEST(CompensatorUse, TiltsAreKnownAsWellAsStated) {
  double squares = 0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Truth truth = tiltedTruth(seed);
    Session session = sessionOf(truth, seed);
    stateCompensator(session, truth, CompensatorUse::Measured, ofCompensator, seed);
    const Measurement measurement = *examine(session).measurement;
    const auto& known = measurement.known;
    ASSERT_EQ(known.size(), 2U);
    for (const KnownNumber& number : known) {
      const bool isAboutX = findParameter(measurement, number)->term == ErrorTerm::VerticalAxisTiltX;
      squares += std::pow((number.value - (isAboutX ? 200 : -200)) / number.sigma, 2);
      ++count;
    }
  }
  const double rms = std::sqrt(squares / count);
  // One face cannot determine the index, the main contribution: σ is that of an index and of a setting error,
  // √2 of it.
  EXPECT_GT(rms, 0.5);
  EXPECT_LT(rms, 1.25);
}

TEST(CompensatorUse, TiltsThatAreKnownAreNoCause) {
  const Truth truth = tiltedTruth(3);
  Session session = sessionOf(truth, 3, "full");
  const Diagnosis alone = diagnosisOf(session);
  ASSERT_FALSE(alone.causes.empty());
  stateCompensator(session, truth, CompensatorUse::Measured, ofCompensator, 3);
  const Diagnosis known = diagnosisOf(session);
  EXPECT_THAT(known.causes, IsEmpty());
  EXPECT_LT(known.after.rms, 0.97 * alone.gap.rms) << "2.0″ to 1.9″, as with the tilt found";
}

// Tilts with the opposite sign are rejected if the readings show them, and the reason is stated. If an arm
// may also sag, the reason is one of the two; if it cannot, the sign is named.
TEST(CompensatorUse, TheOtherSignIsFoundOut) {
  const Truth truth = tiltedTruth(3);
  Session session = sessionOf(truth, 3, "full");
  Truth opposite = truth;
  for (TrueSize& size : opposite.effects) size.value = -size.value;
  stateCompensator(session, opposite, CompensatorUse::Measured, ofCompensator, 3);
  const Diagnosis either = diagnosisOf(session);
  ASSERT_EQ(either.causes.size(), 1U);
  EXPECT_EQ(either.causes[0].effect, "arm_sag");
  EXPECT_THAT(either.causes[0].indistinguishableFrom, testing::Contains("vertical_axis_tilt"));
  EXPECT_THAT(staleSentence(either), HasSubstr("If the known size of vertical axis tilt were out of date"));
  const Diagnosis diagnosis = diagnosisOf(session, {.without = {"arm_sag"}});
  ASSERT_EQ(diagnosis.causes.size(), 1U);
  EXPECT_EQ(diagnosis.causes[0].effect, "vertical_axis_tilt");
  EXPECT_TRUE(diagnosis.causes[0].isStale);
  EXPECT_THAT(staleSentence(diagnosis), HasSubstr("opposite sign"));
}

}  // namespace
}  // namespace alidade
