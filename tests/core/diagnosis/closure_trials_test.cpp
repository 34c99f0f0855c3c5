#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnosis/decision.h"
#include "core/diagnosis/diagnose.h"
#include "core/simulation/blind_trial.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

bool names(const Diagnosis& diagnosis, const std::string& id) {
  if (diagnosis.causes.empty()) return false;
  const Cause& first = diagnosis.causes.front();
  const auto& alike = first.indistinguishableFrom;
  return first.effect == id || std::ranges::find(alike, id) != alike.end();
}

// Sessions of an independent ray tracer whose effects appear in the closures. From residuals alone two thirds
// of them would count as noise. At 97 % two of 64 may be missed.
TEST(ClosureTrials, NameTheCause) {
  int missed = 0, shown = 0, quiet = 0;
  for (const test::Trial& trial : test::closureTrials()) {
    constexpr double clear = 6;
    const Diagnosis diagnosis = *diagnose(trial.measurement);
    if (trial.kind == "none") {
      EXPECT_EQ(diagnosis.verdict, DiagnosisVerdict::WithinNoise) << trial.id;
      ++quiet;
    } else if (trial.visibleSigma >= clear) {
      ++shown;
      missed += names(diagnosis, trial.kind) ? 0 : 1;
    }
  }
  EXPECT_EQ(shown, 56);
  EXPECT_EQ(quiet, 8);
  EXPECT_LE(missed, 1);
}

// 95 % of 64 is 61 ± 2. Fewer than 56 have a probability of one in a hundred, more than 62 of one in seven.
// Of eight of a kind at 88 % at least six are expected.
TEST(ClosureTrials, AreCoveredByWhatMayHaveCausedThem) {
  std::map<std::string, int> covered;
  int all = 0, asModelled = 0;
  for (const test::Trial& trial : test::closureTrials()) {
    const Diagnosis diagnosis = *diagnose(trial.measurement);
    const auto holds = [&](const IntersectionEstimate& estimate) {
      return std::abs(estimate.value - trial.intersection) <= estimate.expanded;
    };
    covered[trial.kind] += holds(*diagnosis.afterwards) ? 1 : 0;
    all += holds(*diagnosis.afterwards) ? 1 : 0;
    asModelled += holds(*diagnosis.before) ? 1 : 0;
  }
  EXPECT_GE(all, 58);
  EXPECT_LE(asModelled, 48);
  for (const auto& [kind, count] : covered) EXPECT_GE(count, 6) << kind;
}

TEST(ClosureTrials, HaveNoWrongVerdict) {
  int given = 0;
  for (test::Trial& trial : test::closureTrials()) {
    const SessionFit fit = fitSession(trial.measurement);
    const Diagnosis diagnosis = *diagnose(trial.measurement, fit);
    const auto decision = decideAcceptance(trial.measurement, fit, &diagnosis);
    ASSERT_TRUE(decision) << trial.id;
    if (decision->verdict == Verdict::Undecided) continue;
    ++given;
    const bool conforms = std::abs(trial.intersection) <= *trial.measurement.tolerance;
    EXPECT_EQ(decision->verdict == Verdict::Accept, conforms) << trial.id;
  }
  EXPECT_GE(given, 40);
}

/// The drift continues at its rate while more positions are measured, and a jump keeps its moment.
Truth goingOn(Truth truth, const Protocol& before, const Protocol& after) {
  const double last = static_cast<double>(plannedRows(before).size() * before.axes.size()) - 1,
               further = static_cast<double>(plannedRows(after).size() * after.axes.size()) - 1;
  for (TrueSize& size : truth.effects)
    if (after.axes.size() > before.axes.size() &&
        (size.term == ErrorTerm::HorizontalDrift || size.term == ErrorTerm::VerticalDrift))
      size.value *= further / last;
  if (truth.jump) truth.jump->moment *= last / further;
  return truth;
}

/// The protocol with the measures carried out, if they need a new session or readings at the end.
std::optional<Protocol> followed(Protocol protocol, const std::vector<Measure>& measures) {
  for (const Measure measure : measures) {
    if (measure == Measure::BothFaces)
      protocol.faces = FacePlan::BothAtEachPlace;
    else if (measure == Measure::WayBack)
      protocol.rounds = 2;
    else if (measure == Measure::SliderReadings)
      protocol.slider = true;
    else if (measure == Measure::At0Again)
      protocol.axes.push_back(0);
    else if (measure == Measure::At180Again)
      protocol.axes.push_back(180);
    else
      return std::nullopt;
  }
  return protocol;
}

// The session is simulated again as advised, with the same true effect. Effects promised to be separated from
// the truth by 6 σ or more must not remain as look-alikes, in 95 % of the promises.
class Promises {
 public:
  void follow(const std::string& id, std::uint64_t seed) {
    const Protocol& paper = *protocolByName("paper");
    const auto trial = drawBlindTrial({.protocol = paper.name, .leastVisible = 8, .kinds = {id}}, seed);
    ASSERT_TRUE(trial);
    const Diagnosis first = *diagnose(*examine(trial->session).measurement);
    if (first.verdict != DiagnosisVerdict::Ambiguous || !names(first, id)) return;
    for (const Advice& advice : first.advice) {
      constexpr double sure = 6;
      const auto protocol = followed(paper, advice.measures);
      const auto& apart = advice.separates;
      if (!protocol || advice.bySigma < sure || std::ranges::find(apart, id) == apart.end()) continue;
      const Truth truth = goingOn(trial->truth, paper, *protocol);
      const Diagnosis next = *diagnose(*examine(*simulate(*protocol, truth, seed + 1000)).measurement);
      Count& count = protocol->axes.size() > 2 ? ofRepeats : ofOthers;
      for (const std::string& other : apart) {
        if (other == id) continue;
        ++count.given;
        count.kept += names(next, id) && !names(next, other) ? 1 : 0;
      }
    }
  }

  struct Count {
    int given = 0, kept = 0;
  };
  Count ofOthers, ofRepeats;
};

TEST(Advice, KeepsItsPromisesWhereItIsFollowed) {
  Promises promises;
  for (const char* id : {"trunnion_tilt", "vertical_drift", "plane_warp", "horizontal_drift",
                         "arc_ellipticity", "plane_tilt", "vertical_axis_tilt"})
    for (std::uint64_t seed = 1; seed <= 12; ++seed) promises.follow(id, seed);
  EXPECT_GT(promises.ofOthers.given, 40);
  EXPECT_GE(promises.ofOthers.kept, 0.95 * promises.ofOthers.given) << "of " << promises.ofOthers.given;
}

// A repeated position separates a drift and a jump from an axial shift: the first two leave a misclosure of
// the repeat, the last does not.
TEST(Advice, KeepsWhatItPromisesOfPositionsMeasuredAgain) {
  Promises promises;
  for (const char* id : {"horizontal_drift", "axial_shift", "orientation_jump", "vertical_drift"})
    for (std::uint64_t seed = 101; seed <= 116; ++seed) promises.follow(id, seed);
  EXPECT_GT(promises.ofRepeats.given, 5);
  EXPECT_GE(promises.ofRepeats.kept, 0.95 * promises.ofRepeats.given) << "of " << promises.ofRepeats.given;
}

}  // namespace
}  // namespace alidade
