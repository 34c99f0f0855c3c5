#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/adjustment/result/session_fit.h"
#include "core/base/angle_text.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

// Transformations that must leave a result unchanged, or change it in a known way. Each test goes from the
// session's texts to the result.

namespace alidade {
namespace {

/// Returns a session without anything that depends on the direction of the circle or on time.
Session sessionOf(const std::string& protocol) {
  Truth truth = drawTruth(21);
  truth.sigmaDistance = 1;
  return *simulate(*protocolByName(protocol), truth, 21);
}

/// Turns the readings of the circle, at the same resolution of 0.1″.
void turnCircle(Session& session, double degrees) {
  const auto turned = [&](const std::string& text) {
    const Angle angle = wrapped(*parseAngle(text) + Angle::fromDegrees(degrees), Angle::fromDegrees(180));
    const std::string typed = formatDms(angle, 1, AngleSigns::Typewriter);
    return typed.starts_with("360") ? "0" + typed.substr(3) : typed;
  };
  for (Position& position : session.positions) {
    position.zero.horizontal = turned(position.zero.horizontal);
    for (Reading& reading : position.readings) reading.horizontal = turned(reading.horizontal);
  }
}

/// Results of the same readings differ by rounding in the solvers: some 1e-11 mm, and for σ relatively the
/// same.
void expectSame(const SessionFit& one, const SessionFit& other) {
  ASSERT_TRUE(one.intersection && other.intersection);
  EXPECT_NEAR(one.intersection->value, other.intersection->value, 1e-9);
  EXPECT_NEAR(one.intersection->sigma, other.intersection->sigma, 1e-7 * one.intersection->sigma);
  EXPECT_NEAR(one.intersection->coverageFactor, other.intersection->coverageFactor, 1e-7);
  for (const int axisDeg : {0, 180}) {
    const ArcFit &a = *one.arcAt(axisDeg), &b = *other.arcAt(axisDeg);
    EXPECT_NEAR(a.circle.x, b.circle.x, 1e-9);
    EXPECT_NEAR(a.circle.y, b.circle.y, 1e-9);
    EXPECT_NEAR(a.circle.radius, b.circle.radius, 1e-9);
    EXPECT_NEAR(a.chiSquare, b.chiSquare, 1e-6 * a.chiSquare);
  }
}

SessionFit fitted(const Session& session) {
  return fitSession(test::measurementOf(session));
}

class InvarianceTest : public testing::TestWithParam<const char*> {};

TEST_P(InvarianceTest, TurningTheHorizontalCircleChangesNothing) {
  const Session session = sessionOf(GetParam());
  const SessionFit before = fitted(session);
  const double zero = parseAngle(session.positions[0].zero.horizontal)->degrees();
  // The circle is turned by an arbitrary angle, and so that the zero or either end of the arc is at 0/360.
  for (const double degrees : {123.0, -zero, -zero + 9.4, -zero - 9.4, -zero + 180.0}) {
    Session turned = session;
    turnCircle(turned, degrees);
    SCOPED_TRACE(degrees);
    // The readings are written to 0.1″ again; a rotation by a multiple of 0.1″ is exact.
    expectSame(before, fitted(turned));
  }
}

TEST_P(InvarianceTest, TheOrderOfPositionsAndRowsChangesNothing) {
  const Session session = sessionOf(GetParam());
  const SessionFit before = fitted(session);
  Session exchanged = session;
  std::swap(exchanged.positions[0], exchanged.positions[1]);
  expectSame(before, fitted(exchanged));
  Session reversed = session;
  for (Position& position : reversed.positions) std::ranges::reverse(position.readings);
  expectSame(before, fitted(reversed));
  Session rotated = session;
  for (Position& position : rotated.positions)
    std::rotate(position.readings.begin(), position.readings.begin() + 5, position.readings.end());
  expectSame(before, fitted(rotated));
}

TEST_P(InvarianceTest, TheNumbersOfRoundsAndPointsAreNamesOnly) {
  const Session session = sessionOf(GetParam());
  Session renamed = session;
  for (Position& position : renamed.positions)
    for (Reading& reading : position.readings) {
      reading.round = std::to_string(7 - std::stoi(reading.round));
      reading.point = std::to_string(100 - std::stoi(reading.point));
    }
  expectSame(fitted(session), fitted(renamed));
}

TEST_P(InvarianceTest, ScalingAllLengthsScalesTheResult) {
  const Measurement measurement = test::measurementOf(sessionOf(GetParam()));
  const SessionFit before = fitSession(measurement);
  for (const double factor : {0.01, 7.0, 100.0}) {
    Measurement scaled = measurement;
    scaled.distance *= factor;
    scaled.sigmaDistance *= factor;
    scaled.nominalRadius *= factor;
    const SessionFit fit = fitSession(scaled);
    EXPECT_NEAR(fit.intersection->value / factor, before.intersection->value, 1e-9);
    EXPECT_NEAR(fit.intersection->expanded / factor, before.intersection->expanded, 1e-9);
    EXPECT_NEAR(fit.arcs[0].circle.radius / factor, before.arcs[0].circle.radius, 1e-9);
    EXPECT_NEAR(fit.sigmas[1].y / factor, before.sigmas[1].y, 1e-9);
    EXPECT_NEAR(fit.joint.chiSquare, before.joint.chiSquare, 1e-6);
  }
}

// In a mirror right becomes left: x changes its sign, the slider runs in the opposite direction, heights
// stay.
TEST_P(InvarianceTest, AMirrorTurnsRightAndLeftAlone) {
  const Measurement measurement = test::measurementOf(sessionOf(GetParam()));
  Measurement mirrored = measurement;
  for (ArcMeasurement& arc : mirrored.arcs)
    for (Sighting& sighting : arc.sightings) {
      sighting.a = -sighting.a;
      if (sighting.slider) sighting.slider = Angle::fromDegrees(180) - *sighting.slider;
    }
  const SessionFit before = fitSession(measurement), after = fitSession(mirrored);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(after.arcs[i].circle.x, -before.arcs[i].circle.x, 1e-9);
    EXPECT_NEAR(after.arcs[i].circle.y, before.arcs[i].circle.y, 1e-9);
    EXPECT_NEAR(after.arcs[i].circle.radius, before.arcs[i].circle.radius, 1e-9);
    EXPECT_NEAR(after.sigmas[i].radiusX, -before.sigmas[i].radiusX, 1e-7);
  }
  EXPECT_NEAR(after.intersection->value, before.intersection->value, 1e-9);
  EXPECT_NEAR(after.intersection->sigma, before.intersection->sigma, 1e-9);
}

// Upside down, the upper arc becomes the lower one: heights change their sign.
TEST_P(InvarianceTest, AMirrorInTheWaterTurnsHeights) {
  const Measurement measurement = test::measurementOf(sessionOf(GetParam()));
  Measurement mirrored = measurement;
  for (ArcMeasurement& arc : mirrored.arcs)
    for (Sighting& sighting : arc.sightings) {
      sighting.e = -sighting.e;
      if (sighting.slider) sighting.slider = -*sighting.slider;
    }
  for (ArcMeasurement& arc : mirrored.arcs) arc.zeroElevation = -arc.zeroElevation;
  const SessionFit before = fitSession(measurement), after = fitSession(mirrored);
  EXPECT_NEAR(after.intersection->value, -before.intersection->value, 1e-9);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(after.arcs[i].circle.x, before.arcs[i].circle.x, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Protocols, InvarianceTest, testing::Values("paper", "full"),
                         [](const auto& protocol) { return std::string(protocol.param); });

}  // namespace
}  // namespace alidade
