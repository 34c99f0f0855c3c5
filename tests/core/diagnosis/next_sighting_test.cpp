#include "core/diagnosis/next_sighting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/statistics.h"
#include "core/diagnosis/planned_uncertainty.h"
#include "core/guidance/sighting_choice.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/simulation/watched_session.h"

namespace alidade {
namespace {

const Protocol& twoFace() {
  return *protocolByName("two-face");
}

/// A session in face 1 at every place of both positions.
WatchedSession readInFaceOne(const Truth& truth) {
  WatchedSession session(twoFace(), truth, 7);
  for (const int axisDeg : {0, 180})
    for (int point = 1; point <= twoFace().points; ++point) session.sight(axisDeg, 1, point, 1);
  return session;
}

Truth withEffect(ErrorTerm term, double value) {
  Truth truth = drawTruth(7);
  truth.effects = {{term, value}};
  return truth;
}

TEST(NextSighting, IsInTheOtherFaceIfOnlyThatTellsTheCollimation) {
  const Truth truth = withEffect(ErrorTerm::Collimation, 12);
  const auto state = sessionSoFar(*readInFaceOne(truth).measurement(), openPlan(templateOf(twoFace())));
  ASSERT_TRUE(state && !state->ranked.empty());
  EXPECT_EQ(state->ranked.front().face, 2);
  EXPECT_TRUE(state->named.empty());
}

TEST(NextSighting, CostsATurnOfTheAxisAndItsZero) {
  SightingPlan plan = openPlan(templateOf(twoFace()));
  plan.minutes = {.turningAxis = 100, .plungingTelescope = 10, .drivingSlider = 1};
  const auto state = sessionSoFar(*readInFaceOne(drawTruth(7)).measurement(), plan);
  ASSERT_TRUE(state);
  for (const NextSighting& next : state->ranked) {
    const bool isThere = !next.turnsAxis && next.point == twoFace().points;
    EXPECT_NEAR(next.minutes,
                minutesOfPointing + (next.turnsAxis ? 100 + minutesOfPointing : 0) +
                    (next.face == 2 ? 10 : 0) + (isThere ? 0 : 1),
                1e-9);
    EXPECT_EQ(next.turnsAxis, next.axisDeg == 0);
  }
}

TEST(NextSighting, NamesTheCauseThatIsThere) {
  const Truth truth = withEffect(ErrorTerm::VerticalIndex, 15);
  WatchedSession session = readInFaceOne(truth);
  for (int point = twoFace().points; point >= 1; --point) session.sight(180, 3, point, 2);
  const auto state = sessionSoFar(*session.measurement(), openPlan(templateOf(twoFace())));
  ASSERT_TRUE(state);
  EXPECT_EQ(state->enough, Enough::Named);
  EXPECT_THAT(state->named, testing::Contains("vertical_index"));
}

TEST(NextSighting, NamesTwoCausesThatAreThere) {
  Truth truth = drawTruth(7);
  truth.effects = {{ErrorTerm::VerticalIndex, 15}, {ErrorTerm::Collimation, -12}};
  WatchedSession session(twoFace(), truth, 7);
  for (const int axisDeg : {0, 180})
    for (int point = 1; point <= twoFace().points; ++point)
      for (const int face : {1, 2}) session.sight(axisDeg, 1, point, face);
  const auto state = sessionSoFar(*session.measurement(), openPlan(templateOf(twoFace())));
  ASSERT_TRUE(state);
  EXPECT_EQ(state->enough, Enough::Named);
  const auto holds = [](const std::vector<std::string>& group, const std::string& cause) {
    return std::ranges::find(group, cause) != group.end();
  };
  const std::vector<std::string>&one = state->named, &other = state->alsoNamed;
  EXPECT_TRUE((holds(one, "vertical_index") && holds(other, "collimation")) ||
              (holds(one, "collimation") && holds(other, "vertical_index")));
}

/// Both faces at a few places show the index error, but hardly any other effect.
TEST(NextSighting, IsNotEnoughWhileAFurtherCauseMayHide) {
  const Truth truth = withEffect(ErrorTerm::VerticalIndex, 25);
  WatchedSession session(twoFace(), truth, 7);
  bool wasNamedBefore = false;
  for (int point = 1; point <= twoFace().points; ++point) {
    for (const int face : {1, 2}) session.sight(0, 1, point, face);
    const auto state = sessionSoFar(*session.measurement(), openPlan(templateOf(twoFace())));
    ASSERT_TRUE(state);
    EXPECT_TRUE(state->alsoNamed.empty()) << point;
    if (state->named.empty()) continue;
    EXPECT_TRUE(state->further.front().cause.empty()) << "most probably there is no further cause";
    wasNamedBefore = wasNamedBefore || (state->enough == Enough::No && !state->isAlone);
  }
  EXPECT_TRUE(wasNamedBefore) << "named, and yet more sightings are recommended";
}

TEST(NextSighting, IsCertainOfAVerdictOnlyBeyondTheRangeOfAllTimes) {
  const auto decided = [](double tolerance) {
    Measurement measurement = *readInFaceOne(drawTruth(7)).measurement();
    measurement.tolerance = tolerance;
    return *sessionSoFar(measurement, openPlan(templateOf(twoFace())));
  };
  const SessionSoFar state = decided(1);
  const double size = std::abs(*state.intersection);
  EXPECT_GT(state.halfWidth, 1.96 * *state.sigma);
  EXPECT_EQ(decided(size + 1.01 * state.halfWidth).enough, Enough::VerdictCertain);
  EXPECT_NE(decided(size + 0.99 * state.halfWidth).enough, Enough::VerdictCertain);
}

/// A place may have another coordinate than planned for its number; its next sighting is at this coordinate.
TEST(NextSighting, FindsNothingWhereThePlacesLieElsewhereThanPlanned) {
  SightingPlan plan = openPlan(templateOf(twoFace()));
  const Measurement measurement = *readInFaceOne(drawTruth(7)).measurement();
  const auto planned = sessionSoFar(measurement, plan);
  for (SightingPlace& place : plan.places) place.s = place.s + Angle::fromDegrees(9);
  const auto elsewhere = sessionSoFar(measurement, plan);
  ASSERT_TRUE(planned && elsewhere);
  EXPECT_LT(planned->logEvidence, 2);
  EXPECT_LT(elsewhere->logEvidence, 2);
}

TEST(NextSighting, CountsNoKnownSizeAsEvidence) {
  const Truth truth = withEffect(ErrorTerm::VerticalIndex, 15);
  WatchedSession session = readInFaceOne(truth);
  for (int point = twoFace().points; point >= 1; --point) session.sight(180, 2, point, 2);
  Measurement measurement = *session.measurement();
  const SightingPlan plan = openPlan(templateOf(twoFace()));
  EXPECT_GT(sessionSoFar(measurement, plan)->logEvidence, 10);
  KnownNumber known;
  known.effect = "vertical_index";
  known.unit = "arcsec";
  known.value = 15;
  known.sigma = 0.5;
  measurement.known = {known};
  EXPECT_LT(sessionSoFar(measurement, plan)->logEvidence, 2);
  measurement.known.clear();
  measurement.effects = {"vertical_index"};
  EXPECT_LT(sessionSoFar(measurement, plan)->logEvidence, 2) << "the model contains it";
}

/// Compares U of these equations with an adjustment of error-free readings with every effect. The first are
/// linear at the circles, the second at the places: 0.5 %.
TEST(NextSighting, HasTheUncertaintyThatAPlanHas) {
  for (const Protocol& protocol : namedProtocols()) {
    const auto session = simulate(protocol, drawTruth(7), 7);
    ASSERT_TRUE(session);
    const Measurement measurement = *examine(*session).measurement;
    const auto state = sessionSoFar(measurement, openPlan(templateOf(protocol)), false);
    const auto planned = plannedUncertainty(measurement, 1);
    ASSERT_TRUE(state && state->sigma && planned) << protocol.name;
    const double factor = coverageFactor(measurement.coverage, DegreesOfFreedom::infinite());
    EXPECT_NEAR(factor * *state->sigma, *planned, 5e-3 * *planned) << protocol.name;
  }
}

TEST(NextSighting, NamesAnEffectOfNoCatalogueAsAForm) {
  Truth warped = drawTruth(7), lobed = drawTruth(7), late = drawTruth(7);
  warped.foreign = {ForeignEffect::Kind::HighWarp, 0.5, 5, 40};
  lobed.harmonic = {.order = 6, .cosine = 0.08, .sine = -0.06};
  late.foreign = {ForeignEffect::Kind::Settling, 25, 0.12};
  for (const Truth& truth : {warped, lobed, late}) {
    const auto state = sessionSoFar(*readInFaceOne(truth).measurement(), openPlan(templateOf(twoFace())));
    ASSERT_TRUE(state);
    EXPECT_THAT(state->named, testing::ElementsAre("form")) << state->causes.front().cause;
  }
}

/// Four places in both faces leave fewer than twelve readings to check a named cause.
TEST(NextSighting, NamesNothingWhileNoReadingIsLeftToCheckIt) {
  const Truth truth = withEffect(ErrorTerm::Collimation, 120);
  WatchedSession session(twoFace(), truth, 7);
  int evident = 0;
  for (int point = 1; point <= 8; ++point) {
    for (const int face : {1, 2}) session.sight(0, 1, point, face);
    const auto state = sessionSoFar(*session.measurement(), openPlan(templateOf(twoFace())));
    ASSERT_TRUE(state);
    const bool isEarly = point <= 4;
    EXPECT_TRUE(!isEarly || state->named.empty()) << point;
    EXPECT_TRUE(point < 8 || !state->named.empty());
    evident += isEarly && state->logEvidence > state->logEvidenceNeeded ? 1 : 0;
  }
  EXPECT_GE(evident, 3) << "the evidence alone would have sufficed";
}

/// An uncatalogued effect looks like noise.
TEST(NextSighting, NeverNamesNoise) {
  Measurement measurement = *readInFaceOne(drawTruth(7)).measurement();
  measurement.sigmaHorizontal = measurement.sigmaHorizontal * 0.2;
  measurement.sigmaVertical = measurement.sigmaVertical * 0.2;
  const auto state = sessionSoFar(measurement, openPlan(templateOf(twoFace())));
  ASSERT_TRUE(state);
  EXPECT_EQ(state->causes.front().cause, "underestimated_noise");
  EXPECT_GT(state->logEvidence, state->logEvidenceNeeded);
  EXPECT_TRUE(state->named.empty());
  EXPECT_NE(state->enough, Enough::Named);
}

}  // namespace
}  // namespace alidade
