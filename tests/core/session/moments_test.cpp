#include <gtest/gtest.h>

#include "core/session/measurement.h"
#include "core/session/session.h"
#include "tests/support/paper_table.h"

// The moments of rows and zeros (`setMoments`).

namespace alidade {
namespace {

Reading timedRow(int point, const std::string& takenAt = {}) {
  Reading row;
  row.point = std::to_string(point);
  row.horizontal = std::to_string(10 + point) + " 00 00";
  row.vertical = "88 00 00";
  row.takenAt = takenAt;
  return row;
}

/// Two positions of three rows each; the zeros are sighted before and after them.
Session threeRowsEach() {
  Session session;
  session.geometry.distanceMm = "2405";
  session.geometry.radiusMm = "400";
  for (const char* axis : {"0", "180"}) {
    Position position;
    position.axisDeg = axis;
    position.zero.horizontal = "10 00 00";
    position.zero.vertical = "90 00 00";
    position.zero.after = {"10 00 03", "90 00 03"};
    for (int point = 1; point <= 3; ++point) position.readings.push_back(timedRow(point));
    session.positions.push_back(position);
  }
  return session;
}

TEST(Moments, StandZerosBesideTheRowsOfTheirPosition) {
  const Measurement measurement = *examine(threeRowsEach()).measurement;
  const ArcMeasurement &first = measurement.arcs[0], &second = measurement.arcs[1];
  EXPECT_EQ(first.zeroSightings[0].order, 0u);
  EXPECT_EQ(first.sightings[0].order, 1u);
  EXPECT_EQ(first.zeroSightings[1].order, 4u);
  EXPECT_EQ(second.zeroSightings[0].order, 5u);
  EXPECT_EQ(second.sightings[2].order, 8u);
  EXPECT_EQ(second.zeroSightings[1].order, 9u);
  EXPECT_DOUBLE_EQ(first.zeroSightings[1].elapsed, 2.0 / 5);
  EXPECT_DOUBLE_EQ(second.zeroSightings[0].elapsed, 3.0 / 5);
  EXPECT_DOUBLE_EQ(first.zero.elapsed, 1.0 / 5) << "of the mean";
  EXPECT_DOUBLE_EQ(second.zero.elapsed, 4.0 / 5);
}

TEST(Moments, OfOneZeroForAllAreBeforeTheFirstRowAndBehindTheLast) {
  Session session = threeRowsEach();
  session.geometry.pointingZeros = "one";
  const Measurement measurement = *examine(session).measurement;
  ASSERT_EQ(measurement.arcs[0].zeroSightings.size(), 1u);
  ASSERT_EQ(measurement.arcs[1].zeroSightings.size(), 1u);
  EXPECT_DOUBLE_EQ(measurement.arcs[0].zeroSightings[0].elapsed, 0);
  EXPECT_DOUBLE_EQ(measurement.arcs[1].zeroSightings[0].elapsed, 1);
  for (const ArcMeasurement& arc : measurement.arcs) EXPECT_DOUBLE_EQ(arc.zero.elapsed, 0.5);
}

TEST(Moments, GoByTheClockWhereEveryRowHasATime) {
  Session session = threeRowsEach();
  const char* const times[2][3] = {
      {"2026-03-01T10:00:00Z", "2026-03-01T10:01:00Z", "2026-03-01T10:02:00Z"},
      {"2026-03-01T12:06:00+02:00", "2026-03-01T10:08:00Z", "2026-03-01T10:10:00Z"}};
  for (std::size_t p = 0; p < 2; ++p)
    for (std::size_t i = 0; i < 3; ++i) session.positions[p].readings[i].takenAt = times[p][i];
  session.positions[1].zero.takenAt = "2026-03-01T10:05:00Z";
  const Measurement timed = *examine(session).measurement;
  EXPECT_DOUBLE_EQ(timed.arcs[0].sightings[1].elapsed, 0.1);
  EXPECT_DOUBLE_EQ(timed.arcs[1].sightings[0].elapsed, 0.6);
  EXPECT_DOUBLE_EQ(timed.arcs[1].zeroSightings[0].elapsed, 0.5);
  EXPECT_DOUBLE_EQ(timed.arcs[0].zeroSightings[0].elapsed, 0) << "without a time: just before the first row";
  session.positions[0].readings[1].takenAt = "about ten";
  const Measurement counted = *examine(session).measurement;
  EXPECT_DOUBLE_EQ(counted.arcs[0].sightings[1].elapsed, 0.2) << "by the rows again";
}

TEST(Moments, KeepOutTheRowsThatAreExcluded) {
  Session session = threeRowsEach();
  session.positions[1].readings[0].excluded = true;
  const Measurement measurement = *examine(session).measurement;
  EXPECT_DOUBLE_EQ(measurement.arcs[1].zeroSightings[0].elapsed, 4.0 / 5) << "beside the first that counts";
  EXPECT_LT(measurement.arcs[1].zeroSightings[0].order, measurement.arcs[1].sightings[0].order);
}

TEST(Moments, StandApartFromTheElevationOfTheZero) {
  Session session = threeRowsEach();
  session.positions[0].zero.vertical = "89 30 00";
  session.positions[1].zero.vertical = "89 30 00";
  for (Position& position : session.positions) position.zero.after = {};
  const Measurement level = *examine(session).measurement;
  for (const ArcMeasurement& arc : level.arcs) EXPECT_NEAR(arc.zeroElevation.degrees(), 0.5, 1e-12);
  session.geometry.verticalCircle = "elevation";  // 89.5° up is not a valid zero of an elevation circle
  const Measurement other = *examine(session).measurement;
  for (const ArcMeasurement& arc : other.arcs) EXPECT_EQ(arc.zeroElevation.radians(), 0);
}

}  // namespace
}  // namespace alidade
