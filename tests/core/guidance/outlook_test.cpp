#include "core/guidance/outlook.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/plan_review.h"
#include "tests/core/guidance/simulated.h"

namespace alidade {
namespace {

/// A session with all results needed for an outlook.
struct Known {
  Session session;
  Measurement measurement;
  SessionFit fit;

  explicit Known(Session read)
      : session(std::move(read)), measurement(*examine(session).measurement), fit(fitSession(measurement)) {}

  Outlook outlook(const SightingProtocol& protocol) const {
    return outlookOf(measurement, fit, nullptr, protocol, progressOf(session, protocol));
  }
};

/// Exact zeros and distance, so that only the noise of the readings remains.
Truth onlyNoise() {
  Truth truth = test::truth();
  truth.sigmaZero = Angle();
  return truth;
}

TEST(Outlook, OfWhatIsThereIsUOfTheFit) {
  for (const char* name : {"paper", "two-face", "paper-slider"}) {
    const Known known(*simulate(*protocolByName(name), test::truth(), 11));
    const Outlook outlook = known.outlook(test::asSimulated(*protocolByName(name)));
    ASSERT_TRUE(outlook.now && known.fit.intersection) << name;
    // The outlook is linearised at readings on the arcs; residuals would change the weights.
    EXPECT_NEAR(outlook.now->ofFit, known.fit.intersection->expanded, 1e-3 * known.fit.intersection->expanded)
        << name;
    ASSERT_FALSE(outlook.ahead.empty());
    EXPECT_NEAR(outlook.ahead.front().expanded.ofFit, outlook.now->ofFit, 1e-9) << "nothing is left";
  }
}

/// Closed form: with noise only, σ of n times as many rounds is 1/√n of it. U also has Student's factor,
/// which is known here (σ as stated), so the noise is too small for an estimate of its own.
TEST(Outlook, OfMoreRoundsGoesDownAsTheRootOfTheirNumber) {
  Protocol plan = test::plan(17, 10, 10, 1);
  Truth exact = onlyNoise();
  const Known known(*simulateWithoutNoise(plan, exact, 11));
  const Outlook outlook = known.outlook(templateOf(plan));
  ASSERT_EQ(outlook.ahead.size(), 3u);
  const double one = outlook.ahead[0].expanded.ofFit;
  for (const RoundsAhead& ahead : outlook.ahead)
    EXPECT_NEAR(ahead.expanded.ofFit, one / std::sqrt(1 + ahead.rounds), 2e-4 * one) << ahead.rounds;
  ASSERT_TRUE(outlook.limit);
  EXPECT_LT(outlook.limit->ofFit, 0.02 * one)
      << "nothing but noise: what 2e-4 of U leave of a difference of squares";
}

/// The comparison is the mean U of sessions in which the further rounds are read, with noise.
TEST(Outlook, IsWhatFurtherRoundsComeTo) {
  Protocol plan = test::plan(9, 10, 20, 3);
  Protocol planned = plan;
  planned.rounds = 1;
  double foreseen = 0, come = 0;
  constexpr int sessions = 40;
  for (int seed = 1; seed <= sessions; ++seed) {
    const Session whole = *simulate(plan, test::truth(), static_cast<std::uint64_t>(seed));
    const Known first(test::firstRounds(whole, 1)), all(whole);
    const Outlook outlook = first.outlook(templateOf(planned));
    foreseen += outlook.ahead.at(2).expanded.ofFit / sessions;
    come += all.fit.intersection->expanded / sessions;
  }
  // s0 of 12 degrees of freedom scatters by 20 %; its mean over 40 sessions scatters by 3.2 %. With 48
  // degrees of freedom this is 1.6 %. The tolerance is three times both together.
  EXPECT_NEAR(foreseen, come, 0.11 * come);
}

/// The rest of a protocol, with half of it read.
TEST(Outlook, OfTheRestOfTheProtocolIsUOfAllOfIt) {
  const Protocol plan = *protocolByName("two-face");
  Truth truth = test::truth();
  const Session whole = *simulateWithoutNoise(plan, truth, 2);
  const Known all(whole), half(test::firstRounds(whole, 1));
  const SightingProtocol protocol = test::asSimulated(plan);
  const Outlook ahead = half.outlook(protocol), there = all.outlook(protocol);
  EXPECT_NEAR(ahead.ahead.front().expanded.ofFit, there.now->ofFit, 1e-3 * there.now->ofFit);
  EXPECT_GT(ahead.now->ofFit, 1.02 * there.now->ofFit) << "the zeros make up most of it";
}

/// U of `plan` for the way back equals that of one more round, and with no further measure that of the
/// existing rows.
TEST(Outlook, AsMeasuredIsThatOfThePlan) {
  const Protocol plan = *protocolByName("paper");
  Session session = *simulateWithoutNoise(plan, test::truth(), 2);
  session.geometry.zeroIs = "unknown";  // else a way back gains little compared with the zeros
  const Known known(session);
  const auto review = reviewPlan(known.measurement, known.fit);
  ASSERT_TRUE(review);
  const Outlook outlook = known.outlook(templateOf(plan));
  ASSERT_TRUE(outlook.now->asMeasured);
  EXPECT_NEAR(*outlook.now->asMeasured, review->attainable.front().expanded,
              1e-3 * review->attainable.front().expanded);
  int compared = 0;
  for (const AttainableUncertainty& one : review->attainable)
    if (one.known.empty() && one.measures == std::vector<Measure>{Measure::WayBack}) {
      EXPECT_NEAR(*outlook.ahead.at(1).expanded.asMeasured, one.expanded, 0.02 * one.expanded);
      ++compared;
    }
  EXPECT_EQ(compared, 1);
}

Session withTolerance(Session session, double tolerance) {
  session.acceptance.toleranceMm = std::to_string(tolerance);
  return session;
}

TEST(Outlook, SaysHowManyRoundsTheVerdictNeeds) {
  const Protocol plan = *protocolByName("full");
  const Session session = *simulateWithoutNoise(plan, test::truth(), 2);
  const Known bare(session);
  const SightingProtocol protocol = test::asSimulated(plan);
  const double delta = std::abs(bare.fit.intersection->value);
  const Outlook free = bare.outlook(protocol);
  EXPECT_FALSE(free.needed);
  EXPECT_FALSE(free.roundsNeeded());
  const auto u = [&](std::size_t rounds) { return *free.ahead.at(rounds).expanded.asMeasured; };
  ASSERT_LT(u(1), u(0));
  const Outlook enough = Known(withTolerance(session, delta + u(0) * 1.01)).outlook(protocol);
  EXPECT_TRUE(enough.isEnough(*enough.now));
  EXPECT_EQ(enough.roundsNeeded(), 0);
  EXPECT_TRUE(enough.instead.empty());
  const Outlook one = Known(withTolerance(session, delta + (u(0) + u(1)) / 2)).outlook(protocol);
  EXPECT_FALSE(one.isEnough(*one.now));
  EXPECT_EQ(one.roundsNeeded(), 1);
  EXPECT_NEAR(*one.needed->asMeasured, (u(0) + u(1)) / 2, 1e-5) << "six decimals of the tolerance";
  const Outlook never = Known(withTolerance(session, delta + *free.limit->asMeasured / 2)).outlook(protocol);
  EXPECT_FALSE(never.roundsNeeded());
  EXPECT_EQ(never.ahead.size(), 3u) << "no more rounds are tried than are worth looking at";
  EXPECT_FALSE(never.instead.empty());
  const Outlook beyond = Known(withTolerance(session, delta - u(0) * 1.01)).outlook(protocol);
  EXPECT_FALSE(beyond.isWithin);
  EXPECT_TRUE(beyond.isEnough(*beyond.now)) << "it can be rejected";
}

TEST(Outlook, OfOnePositionIsNone) {
  Protocol plan = test::plan(9, 10, 20, 1);
  plan.axes = {0};
  const Known known(*simulate(plan, test::truth(), 2));
  const Outlook outlook = known.outlook(templateOf(plan));
  EXPECT_FALSE(outlook.now);
  EXPECT_TRUE(outlook.ahead.empty());
}

TEST(Outlook, IsThereAsSoonAsAZeroIs) {
  const Protocol plan = test::plan(24, 5, 7, 2);
  const Session whole = *simulate(plan, test::truth(), 2);
  const Known known(test::cut(whole, 0, 0)), all(whole);
  const Outlook outlook = known.outlook(templateOf(plan));
  EXPECT_FALSE(outlook.now);
  ASSERT_FALSE(outlook.ahead.empty());
  // The outlook uses the stated noise, while the complete session estimates it with 92 degrees of freedom, to
  // 7.4 % (1σ). The tolerance is three times that.
  EXPECT_NEAR(outlook.ahead.front().expanded.ofFit, all.fit.intersection->expanded,
              0.22 * all.fit.intersection->expanded);
}

TEST(Outlook, KeepsWhatTheDiagnosisFoundBeside) {
  const Protocol plan = *protocolByName("paper");
  Truth truth = test::truth();
  truth.effects.push_back({ErrorTerm::TrunnionTilt, 60});
  const Known known(*simulate(plan, truth, 4));
  const auto diagnosis = diagnose(known.measurement, known.fit);
  ASSERT_TRUE(diagnosis);
  const SightingProtocol protocol = templateOf(plan);
  const Outlook outlook =
      outlookOf(known.measurement, known.fit, &*diagnosis, protocol, progressOf(known.session, protocol));
  EXPECT_GE(*outlook.now->asMeasured, diagnosis->measured->estimate.expanded * 0.999);
  EXPECT_LE(*outlook.ahead.at(2).expanded.asMeasured, *outlook.now->asMeasured);
}

// A known radius that contradicts the readings makes all misfit noise, which then dominates U: closed form,
// as above, 1/√n. The zeros leave 0.02 of U in three rounds. A plan that contradicts the radius, too, has no
// such course: its U grew with the first further round.
TEST(Outlook, CountsAContradictedRadiusOnce) {
  const Protocol plan = *protocolByName("paper");
  Session session = *simulate(plan, test::truth(), 4);
  session.model.radius = "known";
  session.geometry.radiusMm = "399";
  session.geometry.sigmaRadiusMm = "0.01";
  const Known known(session);
  const Outlook outlook = known.outlook(templateOf(plan));
  for (const RoundsAhead& ahead : outlook.ahead)
    EXPECT_NEAR(ahead.expanded.ofFit / outlook.now->ofFit, 1 / std::sqrt(1 + ahead.rounds), 0.04)
        << ahead.rounds;
}

TEST(CarriedOut, HasEverySightingOfTheProtocolAndOfTheFurtherRounds) {
  const Protocol plan = *protocolByName("shifted-circle");
  const Session session = test::cut(*simulate(plan, test::truth(), 2), 0, 20);
  const Known known(session);
  const SightingProtocol protocol = templateOf(plan);
  const auto whole = carriedOut(known.measurement, known.fit, protocol, progressOf(session, protocol), 3);
  ASSERT_TRUE(whole);
  ASSERT_EQ(whole->arcs.size(), 2u);
  for (const ArcMeasurement& arc : whole->arcs) {
    EXPECT_EQ(arc.sightings.size(), 17u * 2 * (2 + 3));
    EXPECT_TRUE(
        std::ranges::all_of(arc.sightings, [](const Sighting& one) { return one.slider.has_value(); }));
    EXPECT_TRUE(arc.zero.isInBothFaces);
  }
}

/// Both faces of a visit see the slider in one place, even with an instrument error, which the fit would
/// otherwise interpret as scatter.
TEST(CarriedOut, LeavesTheSliderWhereItStoodInAVisit) {
  const Protocol plan = *protocolByName("two-face");
  Truth truth = test::truth();
  truth.effects.push_back({ErrorTerm::Collimation, 40});
  const Session session = *simulate(plan, truth, 3);
  const Known known(session);
  const SightingProtocol protocol = test::asSimulated(plan);
  const auto whole = carriedOut(known.measurement, known.fit, protocol, progressOf(session, protocol), 0);
  ASSERT_TRUE(whole);
  int compared = 0;
  for (const ArcMeasurement& arc : whole->arcs)
    for (const Sighting& one : arc.sightings)
      for (const Sighting& other : arc.sightings)
        if (one.point == other.point && one.round == other.round && one.face < other.face) {
          EXPECT_EQ(one.a, other.a);
          EXPECT_EQ(one.e, other.e);
          ++compared;
        }
  EXPECT_EQ(compared, 68) << "17 places there and back, in two positions";
}

/// The outlook starts from the U on the result pages, even with an error that one face cannot show.
TEST(Outlook, StartsFromTheResult) {
  for (const char* name : {"paper", "two-face"}) {
    Truth truth = test::truth();
    truth.effects.push_back({ErrorTerm::TrunnionTilt, 60});
    const Protocol plan = *protocolByName(name);
    const Known known(*simulate(plan, truth, 4));
    const auto diagnosis = diagnose(known.measurement, known.fit);
    ASSERT_TRUE(diagnosis && diagnosis->measured);
    const SightingProtocol protocol = test::asSimulated(plan);
    const Outlook outlook =
        outlookOf(known.measurement, known.fit, &*diagnosis, protocol, progressOf(known.session, protocol));
    EXPECT_EQ(outlook.now->ofFit, known.fit.intersection->expanded) << name;
    EXPECT_EQ(*outlook.now->asMeasured, diagnosis->measured->estimate.expanded) << name;
    for (std::size_t i = 1; i < outlook.ahead.size(); ++i)
      EXPECT_LT(outlook.ahead[i].expanded.ofFit, outlook.ahead[i - 1].expanded.ofFit) << name;
    EXPECT_LT(outlook.limit->ofFit, outlook.ahead.back().expanded.ofFit) << name;
  }
}

}  // namespace
}  // namespace alidade
