#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "core/diagnosis/dependence.h"
#include "tests/support/paper_table.h"
#include "tests/support/verdict_trials.h"

namespace alidade {
namespace {

// If a row is missing or misread by 60″, an undecided verdict becomes accept only if all readings give a
// probability of conformity above 90 %. Near the limit the verdict thus depends on the noise. The bench
// `alidade_verdict_stability` repeats this thousands of times.
TEST(VerdictStability, WorseReadingsDoNotMakeABetterVerdict) {
  int all = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const char* protocol = seed % 2 == 0 ? "paper" : "paper-slider";
    const auto session = test::judged(test::drawnAcceptance(protocol, {}, 4100 + seed));
    if (!session) continue;
    const test::Changes changes = test::changesOf(*session, 4, seed);
    EXPECT_EQ(changes.unsupported, 0) << seed;
    all += changes.all;
  }
  EXPECT_GT(all, 120);
}

/// Leaves out every row with a new fit and diagnosis each.
std::set<std::pair<std::size_t, std::size_t>> allDependences(const test::JudgedSession& session) {
  std::set<std::pair<std::size_t, std::size_t>> rows;
  for (std::size_t arc = 0; arc < session.measurement.arcs.size(); ++arc)
    for (std::size_t i = 0; i < session.measurement.arcs[arc].sightings.size(); ++i) {
      const auto then = test::judged(test::without(session.measurement, arc, i));
      const Verdict verdict = then ? then->decision.verdict : Verdict::Undecided;
      if (verdict != session.decision.verdict)
        rows.emplace(session.measurement.arcs[arc].position, session.measurement.arcs[arc].sightings[i].row);
    }
  return rows;
}

// Every named row is right. If the verdict depends on any row, at least one such row is named in most
// sessions: in all but two of 30, since only 8 rows are left out.
TEST(VerdictStability, NamesRowsOnWhichAVerdictDepends) {
  int dependent = 0, named = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const auto session = test::judged(test::drawnAcceptance("paper", {}, 4200 + seed));
    if (!session) continue;
    const auto all = allDependences(*session);
    const std::vector<Dependence> found =
        dependencesOf(session->measurement, session->fit, &session->diagnosis, session->decision);
    EXPECT_LE(found.size(), mostLeftOut);
    for (const Dependence& dependence : found) {
      EXPECT_TRUE(dependence.isExact);
      EXPECT_TRUE(all.contains({dependence.position, dependence.row})) << seed;
      EXPECT_NE(dependence.without, session->decision.verdict);
    }
    dependent += all.empty() ? 0 : 1;
    named += found.empty() ? 0 : 1;
  }
  EXPECT_GE(named, dependent - 2);
  EXPECT_GE(dependent, 1);
}

// The fit only: Δd is almost linear in the readings. The linear estimate for a long session names the same
// rows as new fits, within 20 % of the shift.
TEST(VerdictStability, TellsOfALongSessionToFirstOrder) {
  Measurement measurement = test::paperMeasurement();
  for (ArcMeasurement& arc : measurement.arcs) {
    const auto sightings = arc.sightings;
    for (int round = 2; arc.sightings.size() <= mostRowsForLeavingOut / 2; ++round)
      for (Sighting sighting : sightings) {
        sighting.round = round;
        sighting.row = arc.sightings.size();
        arc.sightings.push_back(sighting);
      }
  }
  // One elevation with an error of 0.3° moves Δd across the limit of acceptance.
  Angle& elevation = measurement.arcs[0].sightings[3].e;
  elevation = elevation - Angle::fromDegrees(0.3);
  SessionFit fit = fitSession(measurement);
  Measurement less = test::without(measurement, 0, 3);
  const SessionFit then = fitSession(less);
  const double edge = std::abs(fit.intersection->value) + fit.intersection->expanded;
  ASSERT_GT(edge, std::abs(then.intersection->value) + fit.intersection->expanded);
  measurement.tolerance = edge - 1e-6;
  fit = fitSession(measurement);
  const auto decision = decideAcceptance(measurement, fit, nullptr);
  ASSERT_EQ(decision->verdict, Verdict::Undecided);
  const std::vector<Dependence> found = dependencesOf(measurement, fit, nullptr, *decision);
  ASSERT_FALSE(found.empty());
  const auto isTheRow = [](const Dependence& d) { return d.position == 0 && d.row == 3; };
  EXPECT_TRUE(std::ranges::any_of(found, isTheRow));
  for (const Dependence& dependence : found) EXPECT_FALSE(dependence.isExact);
}

}  // namespace
}  // namespace alidade
