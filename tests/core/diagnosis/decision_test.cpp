#include "core/diagnosis/decision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "core/effects/cause_ids.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using Obstacle = AcceptanceDecision::Obstacle;

/// What is believed once a cause was found: normal, U at 95 % of `value`.
Diagnosis found(const std::string& cause, double value, double expanded) {
  constexpr double factor = 1.959963984540054;  // of the normal distribution at 95 %
  Diagnosis diagnosis;
  diagnosis.verdict = DiagnosisVerdict::SingleCause;
  diagnosis.causes.emplace_back().effect = cause;
  diagnosis.measured.emplace().estimate = {value,
                                           expanded / factor,
                                           expanded,
                                           {{1, value, expanded / factor}},
                                           std::numeric_limits<double>::infinity()};
  diagnosis.measured->budget = {{.effect = "plane_warp", .sigma = expanded / factor}};
  return diagnosis;
}

/// Of Table I: Δd 1.308 ± 0.211 mm.
class Decision : public ::testing::Test {
 protected:
  Measurement measurement = test::paperMeasurement();

  AcceptanceDecision at(double tolerance, const Diagnosis* diagnosis) {
    measurement.tolerance = tolerance;
    return *decideAcceptance(measurement, fitSession(measurement), diagnosis);
  }
};

TEST_F(Decision, IsThatOfTheModelWithoutADiagnosis) {
  for (const auto& [tolerance, verdict, obstacle] :
       {std::tuple(2.5, Verdict::Accept, Obstacle::None),
        std::tuple(1.3, Verdict::Undecided, Obstacle::Uncertainty),
        std::tuple(0.5, Verdict::Reject, Obstacle::None)}) {
    const AcceptanceDecision decision = at(tolerance, nullptr);
    EXPECT_EQ(decision.verdict, verdict) << tolerance;
    EXPECT_EQ(decision.asModelled, verdict) << tolerance;
    EXPECT_EQ(decision.asFound, std::nullopt) << tolerance;
    EXPECT_EQ(decision.obstacle, obstacle) << tolerance;
    EXPECT_FALSE(decision.showsBoth) << tolerance;
  }
}

// All nine pairs of what the model and what the diagnosis say: accept or reject only where both do.
TEST_F(Decision, NeedsBothAccounts) {
  const auto valueFor = [](Verdict verdict) {
    return verdict == Verdict::Accept ? 0.0 : verdict == Verdict::Reject ? 9.0 : -1.3;
  };
  for (const auto& [tolerance, modelled] :
       {std::pair(1.52, Verdict::Accept), std::pair(1.3, Verdict::Undecided),
        std::pair(1.09, Verdict::Reject)})
    for (const Verdict then : {Verdict::Accept, Verdict::Undecided, Verdict::Reject}) {
      const Diagnosis diagnosis = found("collimation", valueFor(then), 0.5);
      const AcceptanceDecision decision = at(tolerance, &diagnosis);
      EXPECT_EQ(decision.asModelled, modelled);
      EXPECT_EQ(decision.asFound, then);
      EXPECT_TRUE(decision.showsBoth);
      EXPECT_EQ(decision.verdict, modelled == then ? modelled : Verdict::Undecided);
      EXPECT_EQ(decision.obstacle, modelled != then                 ? Obstacle::Contradiction
                                   : modelled == Verdict::Undecided ? Obstacle::Uncertainty
                                                                    : Obstacle::None);
    }
}

TEST_F(Decision, IsOpenWhereTheCausesLeaveTheIntersectionUndetermined) {
  Diagnosis diagnosis = found("collimation", 0, 0.1);
  diagnosis.measured.reset();
  const AcceptanceDecision decision = at(2.5, &diagnosis);
  EXPECT_EQ(decision.verdict, Verdict::Undecided);
  EXPECT_EQ(decision.obstacle, Obstacle::Contradiction);
  EXPECT_EQ(decision.conformance, std::nullopt);
}

TEST_F(Decision, ShowsBothAccountsWhereThereAreTwo) {
  EXPECT_FALSE(at(2.5, nullptr).showsBoth);
  const Diagnosis diagnosis = found(std::string(noiseId), 1.3, 0.2);
  EXPECT_TRUE(at(2.5, &diagnosis).showsBoth);
}

TEST_F(Decision, TellsNoiseFromWhatIsMore) {
  EXPECT_FALSE(isMoreThanNoise(found(std::string(noiseId), 1.3, 0.2)));
  EXPECT_TRUE(isMoreThanNoise(found("gravity_sag", 1.3, 0.2)));
  Diagnosis diagnosis;
  EXPECT_FALSE(isMoreThanNoise(diagnosis));
  diagnosis.verdict = DiagnosisVerdict::NotInCatalogue;
  EXPECT_TRUE(isMoreThanNoise(diagnosis));
}

// U at a coverage of 1 % is next to nothing, and would accept whatever lies below the limit.
TEST_F(Decision, NeedsACoverage) {
  for (const auto& [coverage, obstacle] :
       {std::pair(0.01, Obstacle::Coverage), std::pair(0.89, Obstacle::Coverage),
        std::pair(0.9, Obstacle::None), std::pair(0.99, Obstacle::None)}) {
    measurement.coverage = coverage;
    const Diagnosis diagnosis = found("collimation", 1.3, 0.2);
    const AcceptanceDecision decision = at(2.5, &diagnosis);
    EXPECT_EQ(decision.obstacle, obstacle) << coverage;
    EXPECT_EQ(decision.verdict, obstacle == Obstacle::None ? Verdict::Accept : Verdict::Undecided);
    EXPECT_EQ(decision.conformance.has_value(), obstacle == Obstacle::None);
  }
}

// At the limit ± U of a normal distribution lie 2.5 % and 97.5 %, at the limit half of it; two accounts by
// their shares.
TEST_F(Decision, StatesTheProbabilityOfConformance) {
  constexpr double rounding = 1e-6;
  Diagnosis diagnosis = found("collimation", 1.7, 0.3);
  EXPECT_NEAR(*at(2, &diagnosis).conformance, 0.975, rounding);
  EXPECT_NEAR(*at(1.7, &diagnosis).conformance, 0.5, rounding);
  EXPECT_NEAR(*at(1.4, &diagnosis).conformance, 0.025, rounding);
  diagnosis.measured->estimate.accounts = {{3, 0, 0.01}, {1, 5, 0.01}};
  EXPECT_NEAR(*at(1, &diagnosis).conformance, 0.75, rounding);
  diagnosis.measured->estimate.degreesOfFreedom = 1;  // Cauchy's distribution: half of it within ± 1
  diagnosis.measured->estimate.accounts = {{1, 2, 0.5}};
  EXPECT_NEAR(*at(2.5, &diagnosis).conformance, 0.75 - std::atan(0.5 / 4.5) / std::numbers::pi, rounding);
  const Intersection modelled = *fitSession(measurement).intersection;
  EXPECT_NEAR(*at(modelled.value + modelled.expanded, nullptr).conformance, 0.975, rounding);
}

// Of a normal distribution 2.5 % lie beyond either end of U at 95 %, and 5 % beyond both where these are the
// limits of the tolerance. Student's has half of it beyond ±1 with one degree of freedom.
TEST(GreatestRisk, IsThatAtTheEdgesOfTheGuardBand) {
  constexpr double rounding = 1e-5;
  IntersectionEstimate estimate = found("collimation", 1.7, 0.3).measured->estimate;
  EXPECT_NEAR(*greatestRisk(estimate, 2.5), 0.025, rounding);
  EXPECT_NEAR(*greatestRisk(estimate, 0.3), 0.05, rounding);
  EXPECT_NEAR(*greatestRisk(estimate, 0.2), 0.025, rounding) << "nothing is accepted, too much rejected";
  estimate.expanded = 0;
  EXPECT_NEAR(*greatestRisk(estimate, 2.5), 0.5, rounding) << "no guard";
  estimate = {.value = 0, .sigma = 1, .expanded = 1, .accounts = {{1, 0, 1}}, .degreesOfFreedom = 1};
  EXPECT_NEAR(*greatestRisk(estimate, 1e6), 0.25, rounding);
  estimate.degreesOfFreedom = 0;
  EXPECT_FALSE(greatestRisk(estimate, 2.5));
}

// One account in twenty lies above by more than U, none below: accepted at the upper edge, all of it is
// beyond.
TEST(GreatestRisk, IsThatOfTheHeavierSide) {
  const IntersectionEstimate estimate{.value = 0,
                                      .sigma = 0.5,
                                      .expanded = 1,
                                      .accounts = {{19, 0, 0.01}, {1, 2, 0.01}},
                                      .degreesOfFreedom = std::numeric_limits<double>::infinity()};
  EXPECT_NEAR(*greatestRisk(estimate, 10), 0.05, 1e-9);
}

TEST_F(Decision, IsOpenWhereThePositionsDoNotClose) {
  const Closure failing{Closure::Of::Centre, 0.65, 0.09, 1e-9}, sound{Closure::Of::Centre, 0.05, 0.09, 0.6};
  Diagnosis diagnosis = found("collimation", 1.3, 0.2);
  diagnosis.closures = {{failing, sound}};
  EXPECT_EQ(at(2.5, &diagnosis).verdict, Verdict::Accept) << "the cause accounts for it";
  diagnosis.closures = {{failing, failing}};
  const AcceptanceDecision decision = at(2.5, &diagnosis);
  EXPECT_EQ(decision.verdict, Verdict::Undecided);
  EXPECT_EQ(decision.asModelled, Verdict::Accept);
  EXPECT_EQ(decision.obstacle, Obstacle::Misclosure);
  EXPECT_EQ(decision.conformance, std::nullopt);
  EXPECT_EQ(at(0.5, &diagnosis).verdict, Verdict::Undecided);
}

TEST_F(Decision, IsWithheldWithLengthsInDoubt) {
  measurement.nominalRadius = 250;
  const Diagnosis diagnosis = found("collimation", 0, 0.1);
  const AcceptanceDecision decision = at(2.5, &diagnosis);
  EXPECT_EQ(decision.verdict, Verdict::Undecided);
  EXPECT_EQ(decision.obstacle, Obstacle::Lengths);
  EXPECT_EQ(decision.conformance, std::nullopt);
}

TEST_F(Decision, NeedsATolerance) {
  measurement.tolerance.reset();
  EXPECT_EQ(decideAcceptance(measurement, fitSession(measurement), nullptr), std::nullopt);
}

}  // namespace
}  // namespace alidade
