#include "core/guidance/forecast.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/angle_text.h"
#include "tests/core/guidance/simulated.h"

namespace alidade {
namespace {

struct Foreseen {
  int known = 0, unknown = 0;
  double farthest = 0;       ///< arcseconds, for readings on a fitted arc
  double farthestShare = 0;  ///< of the tolerance, for all
};

/// Reads a simulated session row by row, predicting each from those before it.
Foreseen foresee(const Session& whole, const SightingProtocol& protocol) {
  Foreseen seen;
  for (std::size_t p = 0; p < whole.positions.size(); ++p)
    for (std::size_t row = 0; row < whole.positions[p].readings.size(); ++row) {
      const Session session = test::cut(whole, p, row);
      const Examined examined = examine(session);
      const SessionFit fit = fitSession(*examined.measurement);
      const ProtocolProgress progress = progressOf(session, protocol);
      EXPECT_TRUE(progress.next) << p << " " << row;
      const FollowedSighting& next = progress.sightings[*progress.next];
      const Reading& read = whole.positions[p].readings[row];
      EXPECT_EQ(std::to_string(next.planned.point), read.point) << p << " " << row;
      const auto expected = forecast(*examined.measurement, fit, protocol, progress)[*progress.next];
      ++(expected ? seen.known : seen.unknown);
      if (!expected) continue;
      const double miss =
          std::max(std::abs(wrapped(*parseAngle(read.horizontal) - expected->horizontal).arcseconds()),
                   std::abs(wrapped(*parseAngle(read.vertical) - expected->vertical).arcseconds()));
      seen.farthestShare = std::max(seen.farthestShare, miss / expected->tolerance.arcseconds());
      if (fit.arcOfPosition(p)) seen.farthest = std::max(seen.farthest, miss);
    }
  return seen;
}

// The slider is within 60″ (1σ) of its mark at each visit, which is 10″ at the theodolite. In 500 rows the
// difference of two visits stays below 4.5 σ. The coordinate of a new place is as accurate.
const double asTheSliderComes = 60 * 400.0 / 2400 * std::sqrt(2) * 4.5;

TEST(Forecast, IsNearEveryReadingOfEveryNamedProtocol) {
  for (const Protocol& named : namedProtocols()) {
    const Session session = *simulate(named, test::truth(), 3);
    const Foreseen seen = foresee(session, test::asSimulated(named));
    EXPECT_EQ(seen.unknown, 0) << named.name << ": coordinates tell of every place";
    EXPECT_LT(seen.farthest, asTheSliderComes) << named.name;
    EXPECT_LT(seen.farthestShare, 1) << named.name;
  }
}

TEST(Forecast, HoldsForOddGeometriesToo) {
  const Protocol plans[] = {test::plan(3, 20, 70, 2), test::plan(24, 5, 7.3, 1, FacePlan::BothAtEachPlace),
                            test::plan(5, 40, 20, 2, FacePlan::Alternating)};
  for (const Protocol& plan : plans)
    for (const VerticalCircle circle : {VerticalCircle::Zenith, VerticalCircle::Elevation}) {
      const Foreseen seen = foresee(*simulate(plan, test::truth(circle), 5), test::asSimulated(plan));
      EXPECT_EQ(seen.unknown, 0) << plan.points;
      EXPECT_LT(seen.farthest, asTheSliderComes) << plan.points;
      EXPECT_LT(seen.farthestShare, 1) << plan.points;
    }
}

TEST(Forecast, IsOfOnePositionAlone) {
  Protocol plan = test::plan(9, 10, 20, 2);
  plan.axes = {180};
  const Foreseen seen = foresee(*simulate(plan, test::truth(), 5), test::asSimulated(plan));
  EXPECT_EQ(seen.unknown, 0);
  EXPECT_LT(seen.farthestShare, 1);
}

/// The second position predicted from the first, before its zero is sighted: 90° farther on the circle.
TEST(Forecast, TurnsTheCircleAsTheProtocolDoes) {
  const Protocol named = *protocolByName("shifted-circle");
  const Session whole = *simulate(named, test::truth(), 7);
  const Session session = test::cut(whole, 0, whole.positions[0].readings.size());
  const Examined examined = examine(session);
  const SightingProtocol protocol = templateOf(named);
  const ProtocolProgress progress = progressOf(session, protocol);
  const auto expected =
      forecast(*examined.measurement, fitSession(*examined.measurement), protocol, progress);
  int seen = 0;
  for (std::size_t i = 0; i < progress.sightings.size(); ++i) {
    const PlannedSighting& planned = progress.sightings[i].planned;
    if (planned.axisDeg != 180) continue;
    ASSERT_TRUE(expected[i]);
    if (planned.isZero && planned.face == 1) {
      EXPECT_NEAR(
          wrapped(expected[i]->horizontal - *parseAngle(whole.positions[1].zero.horizontal)).arcseconds(), 0,
          60);
    }
    if (planned.isZero) continue;
    const auto row = std::ranges::find_if(whole.positions[1].readings, [&](const Reading& reading) {
      return reading.point == std::to_string(planned.point) && std::stoi(reading.round) == planned.round &&
             std::stoi(reading.face) == planned.face;
    });
    ASSERT_NE(row, whole.positions[1].readings.end());
    EXPECT_LT(std::abs(wrapped(*parseAngle(row->horizontal) - expected[i]->horizontal).radians()),
              expected[i]->tolerance.radians());
    ++seen;
  }
  EXPECT_EQ(seen, 68);
}

/// α − 180° and 360° − β.
TEST(Forecast, TellsTheZeroInTheOtherFace) {
  Session session = blankSession();
  session.geometry.distanceMm = "2405";
  session.geometry.radiusMm = "400";
  session.positions[0].zero.horizontal = "10°";
  session.positions[0].zero.vertical = "90°00'30\"";
  SightingProtocol protocol = templateOf(*protocolByName("two-face"));
  const auto measurement = examine(session).measurement;
  ASSERT_TRUE(measurement);
  const ProtocolProgress progress = progressOf(session, protocol);
  ASSERT_TRUE(progress.sightings[*progress.next].planned.isZero);
  const auto expected = forecast(*measurement, fitSession(*measurement), protocol, progress)[*progress.next];
  ASSERT_TRUE(expected);
  EXPECT_NEAR(expected->horizontal.degrees(), 190, 1e-9);
  EXPECT_NEAR(expected->vertical.degrees(), 270 - 30.0 / 3600, 1e-9);
}

TEST(Forecast, KnowsNothingBeforeTheFirstZero) {
  Session session = blankSession();
  session.geometry.distanceMm = "2405";
  session.geometry.radiusMm = "400";
  const SightingProtocol protocol = templateOf(*protocolByName("paper"));
  const auto measurement = examine(session).measurement;
  ASSERT_TRUE(measurement);
  for (const auto& one :
       forecast(*measurement, fitSession(*measurement), protocol, progressOf(session, protocol)))
    EXPECT_FALSE(one);
}

}  // namespace
}  // namespace alidade
