#include "core/simulation/planned_session.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "core/session/measurement.h"
#include "core/simulation/simulate.h"

namespace alidade {
namespace {

/// The rows of a protocol, without readings.
Session unread(const char* protocol) {
  Session session = *simulate(*protocolByName(protocol), drawTruth(3), 3);
  for (Position& position : session.positions) {
    position.zero.horizontal = position.zero.vertical = "";
    for (Reading& reading : position.readings) reading.horizontal = reading.vertical = "";
  }
  return session;
}

// Readings are written to 0.001″; at 2405 mm that is 0.01 µm, and some hundredths of it after the fit.
TEST(PlannedSession, ReadsTheNominalGuidewayInThought) {
  for (const char* protocol : {"paper", "full"}) {
    const Examined examined = examine(withPlannedReadings(unread(protocol)));
    ASSERT_TRUE(examined.problems.empty()) << examined.problems.front().text();
    const SessionFit fit = fitSession(*examined.measurement);
    ASSERT_TRUE(fit.intersection);
    EXPECT_NEAR(fit.intersection->value, 0, 1e-4);
    EXPECT_NEAR(fit.arcs[0].circle.radius, 400, 1e-4);
  }
}

TEST(PlannedSession, TakesThePlaceFromTheSliderElseSpreadsThePoints) {
  const Measurement even = *examine(withPlannedReadings(unread("paper"))).measurement;
  const ArcMeasurement& lower = even.arcs[1];
  const double expected = std::atan2(400 * std::cos(10 * M_PI / 180), 2405);
  EXPECT_NEAR(lower.sightings[0].a.radians(), expected, 1e-8);  // point 1 at 10°, φ = −10° at axis 180°
  EXPECT_LT(lower.sightings[0].e.radians(), 0);
  Session placed = unread("full");
  placed.positions[0].readings[0].slider = "90°00'00\"";
  const Measurement measurement = *examine(withPlannedReadings(placed)).measurement;
  EXPECT_NEAR(measurement.arcs[0].sightings[0].a.radians(), 0, 1e-8);
}

TEST(PlannedSession, KeepsWhatWasTyped) {
  const Session read = *simulate(*protocolByName("full"), drawTruth(3), 3);
  EXPECT_EQ(withPlannedReadings(read), read);
  Session odd = unread("paper");
  odd.positions[0].readings[2].horizontal = "nonsense";
  odd.positions[1].axisDeg = "45";
  const Session planned = withPlannedReadings(odd);
  EXPECT_EQ(planned.positions[0].readings[2], odd.positions[0].readings[2]);
  EXPECT_EQ(planned.positions[1], odd.positions[1]);
  Session shapeless = unread("paper");
  shapeless.geometry.radiusMm = "";
  EXPECT_EQ(withPlannedReadings(shapeless), shapeless);
}

}  // namespace
}  // namespace alidade
