#include "core/session/zero_mean.h"

#include <gtest/gtest.h>

#include "core/session/measurement.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

/// The paper's session with zeros in both faces before and after the rows, which scatter and move.
Session sightedFourTimes(VerticalCircle circle) {
  Session session = test::paperSession();
  const bool isZenith = circle == VerticalCircle::Zenith;
  session.geometry.verticalCircle = isZenith ? "zenith" : "elevation";
  for (Position& position : session.positions) {
    position.zero = {};
    position.zero.horizontal = "341 52 30.0";
    position.zero.vertical = isZenith ? "90 00 02.0" : "0 00 01.0";
    position.zero.after = {"341 52 34.0", isZenith ? "89 59 58.0" : "0 00 03.0"};
    position.zero.faceTwo = {"161 52 41.0", isZenith ? "270 00 11.0" : "180 00 10.0"};
    position.zero.afterInTwo = {"161 52 43.0", isZenith ? "270 00 05.0" : "180 00 05.0"};
  }
  return session;
}

// Leaving a sighting out gives the measurement of a session in which nobody typed it: zero, readings,
// moments, σ. Angles are sums of a few numbers below 2π, so they agree to 1e-14 rad.
TEST(ZeroMean, LeavesOutASightingAsIfItHadNotBeenTyped) {
  for (const VerticalCircle circle : {VerticalCircle::Zenith, VerticalCircle::Elevation})
    for (const ZeroSlot& slot : furtherZeros) {
      Session session = sightedFourTimes(circle);
      const Measurement all = *examine(session).measurement;
      session.positions[1].zero.*slot.sighting = {};
      const Measurement wanted = *examine(session).measurement;
      // Face 2 only once: the zero of the other position keeps both of its sightings in it.
      const auto index = static_cast<std::size_t>(std::ranges::find_if(all.arcs[1].zeroSightings,
                                                                       [&](const SightedZero& zero) {
                                                                         return zero.face == slot.face &&
                                                                                zero.isAfter == slot.isAfter;
                                                                       }) -
                                                  all.arcs[1].zeroSightings.begin());
      ASSERT_TRUE(isCheckedZero(all, 1, index)) << slot.key;
      const Measurement found = withoutZeroSighting(all, 1, index);
      SCOPED_TRACE(slot.key);
      EXPECT_NEAR(found.zeroScatter, wanted.zeroScatter, 1e-12);
      for (std::size_t a = 0; a < 2; ++a) {
        const ArcMeasurement &arc = found.arcs[a], &other = wanted.arcs[a];
        EXPECT_NEAR(arc.zeroHorizontal.radians(), other.zeroHorizontal.radians(), 1e-14);
        EXPECT_NEAR(arc.zeroVertical.radians(), other.zeroVertical.radians(), 1e-14);
        EXPECT_NEAR(arc.zeroElevation.radians(), other.zeroElevation.radians(), 1e-14);
        EXPECT_EQ(arc.zero.count, other.zero.count);
        EXPECT_DOUBLE_EQ(arc.zero.factor, other.zero.factor);
        EXPECT_NEAR(arc.zero.elapsed, other.zero.elapsed, 1e-14);
        ASSERT_EQ(arc.zero.moved.has_value(), other.zero.moved.has_value());
        EXPECT_NEAR(arc.zero.moved->vertical.radians(), other.zero.moved->vertical.radians(), 1e-14);
        EXPECT_NEAR(arc.zero.moved->apartVertical.radians(), other.zero.moved->apartVertical.radians(),
                    1e-14);
        ASSERT_EQ(arc.sightings.size(), other.sightings.size());
        for (std::size_t i = 0; i < arc.sightings.size(); ++i) {
          EXPECT_NEAR(arc.sightings[i].a.radians(), other.sightings[i].a.radians(), 1e-14);
          EXPECT_NEAR(arc.sightings[i].e.radians(), other.sightings[i].e.radians(), 1e-14);
          EXPECT_EQ(arc.sightings[i].order, other.sightings[i].order);
        }
        ASSERT_EQ(arc.zeroSightings.size(), other.zeroSightings.size());
        for (std::size_t i = 0; i < arc.zeroSightings.size(); ++i) {
          EXPECT_NEAR(arc.zeroSightings[i].a.radians(), other.zeroSightings[i].a.radians(), 1e-14);
          EXPECT_NEAR(arc.zeroSightings[i].e.radians(), other.zeroSightings[i].e.radians(), 1e-14);
          EXPECT_EQ(arc.zeroSightings[i].order, other.zeroSightings[i].order);
        }
      }
    }
}

// A zero needs another sighting in the face that loses one, and one that all positions share is never left
// out.
TEST(ZeroMean, ChecksASightingByAnotherInItsFace) {
  Session session = sightedFourTimes(VerticalCircle::Zenith);
  for (Position& position : session.positions) position.zero.afterInTwo = {};
  const Measurement measurement = *examine(session).measurement;
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(isCheckedZero(measurement, 0, i), measurement.arcs[0].zeroSightings[i].face == 1);
  session.geometry.pointingZeros = "one";
  const Measurement one = *examine(session).measurement;
  ASSERT_TRUE(one.hasOneZero());
  EXPECT_FALSE(isCheckedZero(one, 0, 0));
}

}  // namespace
}  // namespace alidade
