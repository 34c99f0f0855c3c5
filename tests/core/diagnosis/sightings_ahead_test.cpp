#include "core/diagnosis/sightings_ahead.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/effects/catalogue.h"
#include "core/guidance/sighting_choice.h"
#include "core/simulation/protocol.h"
#include "core/simulation/watched_session.h"

namespace alidade {
namespace {

const Protocol& watched() {
  return *protocolByName("two-face");
}

WatchedSession begun(const Truth& truth, std::uint64_t seed) {
  WatchedSession session(watched(), truth, seed);
  session.sight(0, 1, 1, 1);
  return session;
}

/// U depends on the sightings and not on their values: the same sightings, simulated with noise in the same
/// order, lead to the same U. The noise moves the circles at which the equations are linear: 2 %.
TEST(SightingsAhead, ComeToTheSameUncertaintyWhenTheyAreTaken) {
  const Truth truth = drawTruth(3);
  WatchedSession session = begun(truth, 3);
  const SightingPlan plan = openPlan(templateOf(watched()));
  for (const double wanted : {0.6, 0.3}) {
    const SightingsAhead ahead = sightingsFor(wanted, *session.measurement(), plan);
    ASSERT_TRUE(ahead.isReached) << wanted;
    EXPECT_LE(*ahead.expanded, wanted);
    WatchedSession taken = begun(truth, 3);
    double minutes = 0;
    for (const NextSighting& next : ahead.sightings) {
      taken.sight(next.axisDeg, next.round, next.point, next.face);
      minutes += next.minutes;
    }
    EXPECT_DOUBLE_EQ(minutes, ahead.minutes);
    const auto state = sessionSoFar(*taken.measurement(), plan, false);
    ASSERT_TRUE(state && state->sigma);
    EXPECT_NEAR(1.96 * *state->sigma, *ahead.expanded, 0.02 * *ahead.expanded) << wanted;
  }
}

TEST(SightingsAhead, AreFewerAndQuickerThanTheOrderOfTheProtocol) {
  const Truth truth = drawTruth(3);
  WatchedSession whole(watched(), truth, 3);
  for (const int axisDeg : {0, 180})
    for (int point = 1; point <= watched().points; ++point)
      for (const int face : {1, 2}) whole.sight(axisDeg, 1, point, face);
  const SightingPlan plan = openPlan(templateOf(watched()));
  const double reached = 1.96 * *sessionSoFar(*whole.measurement(), plan, false)->sigma;
  const SightingsAhead ahead = sightingsFor(reached, *begun(truth, 3).measurement(), plan);
  ASSERT_TRUE(ahead.isReached);
  EXPECT_LT(ahead.sightings.size() + 1, whole.sightings());
}

TEST(SightingsAhead, SayWhatIsNotReached) {
  const WatchedSession session = begun(drawTruth(3), 3);
  SightingPlan plan = openPlan(templateOf(watched()));
  const SightingsAhead few = sightingsFor(1e-4, *session.measurement(), plan, 12);
  EXPECT_FALSE(few.isReached);
  EXPECT_EQ(few.sightings.size(), 12u);
  EXPECT_FALSE(few.instead.empty());
  plan.canTurnAxis = false;
  EXPECT_FALSE(sightingsFor(0.3, *session.measurement(), plan, 5).expanded) << "Δd needs both positions";
}

/// Makes each number of an effect known to a millionth of its plausible size.
void know(Measurement& measurement, std::string_view id) {
  for (const EffectParameter& parameter : effectById(id)->parameters)
    measurement.known.push_back({.effect = std::string(id),
                                 .parameter = std::string(parameter.name),
                                 .unit = std::string(parameter.unit),
                                 .value = 0,
                                 .sigma = 1e-6 * parameter.plausible});
}

/// With this effect known, or with slider readings, the promised U is reached. The most informative sightings
/// are then others: 2 %.
TEST(SightingsAhead, SayWhatWouldReachFurther) {
  const WatchedSession session = begun(drawTruth(3), 3);
  const SightingPlan plan = openPlan(templateOf(watched()));
  const SightingsAhead ahead = sightingsFor(1e-4, *session.measurement(), plan, 20);
  ASSERT_GT(ahead.instead.size(), 1u);
  EXPECT_EQ(ahead.instead.front().expanded, *ahead.expanded);
  for (const AttainableUncertainty& one : ahead.instead) {
    EXPECT_GE(ahead.expanded, one.expanded);
    if (one.known.empty()) continue;
    Measurement knowing = *session.measurement();
    know(knowing, one.known);
    const SightingsAhead then = sightingsFor(1e-4, knowing, plan, 20);
    EXPECT_LE(*then.expanded, 1.02 * one.expanded) << one.known;
  }
}

TEST(SightingsAhead, StopWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  const WatchedSession session = begun(drawTruth(3), 3);
  EXPECT_LE(sightingsFor(1e-4, *session.measurement(), openPlan(templateOf(watched())), 150, stop.get_token())
                .sightings.size(),
            1u);
}

}  // namespace
}  // namespace alidade
