#include "core/diagnosis/decision.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <tuple>
#include <utility>

#include "core/base/statistics.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/effects/cause_ids.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using Obstacle = AcceptanceDecision::Obstacle;

/// The diagnosis with one cause found. Δd is `value` mm, normal, with U = `expanded` at 95 %.
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

/// The session of Table I: Δd 1.308 ± 0.211 mm.
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

// All nine pairs of verdicts of the model and of the diagnosis: accept or reject only if both agree.
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

// U at a coverage of 1 % is almost zero, and would accept everything below the limit.
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

// At the limit ± U the probabilities of a normal distribution are 2.5 % and 97.5 %, at the limit 50 %. Two
// accounts count with their shares.
TEST_F(Decision, StatesTheProbabilityOfConformance) {
  constexpr double rounding = 1e-6;
  Diagnosis diagnosis = found("collimation", 1.7, 0.3);
  EXPECT_NEAR(*at(2, &diagnosis).conformance, 0.975, rounding);
  EXPECT_NEAR(*at(1.7, &diagnosis).conformance, 0.5, rounding);
  EXPECT_NEAR(*at(1.4, &diagnosis).conformance, 0.025, rounding);
  diagnosis.measured->estimate.explanations = {{3, 0, 0.01}, {1, 5, 0.01}};
  EXPECT_NEAR(*at(1, &diagnosis).conformance, 0.75, rounding);
  diagnosis.measured->estimate.degreesOfFreedom = 1;  // Cauchy's distribution: half of the probability within
                                                      // ± 1
  diagnosis.measured->estimate.explanations = {{1, 2, 0.5}};
  EXPECT_NEAR(*at(2.5, &diagnosis).conformance, 0.75 - std::atan(0.5 / 4.5) / std::numbers::pi, rounding);
  const Intersection modelled = *fitSession(measurement).intersection;
  EXPECT_NEAR(*at(modelled.value + modelled.expanded, nullptr).conformance, 0.975, rounding);
}

TEST_F(Decision, IsOpenWhereTheGapIsUnexplained) {
  Diagnosis diagnosis = found("collimation", 1.3, 0.2);
  diagnosis.unexplained.chance = thresholds.mostUnexplained;
  EXPECT_EQ(at(2.5, &diagnosis).verdict, Verdict::Accept);
  diagnosis.unexplained.chance = thresholds.mostUnexplained + 1e-9;
  const AcceptanceDecision decision = at(2.5, &diagnosis);
  EXPECT_EQ(decision.verdict, Verdict::Undecided);
  EXPECT_EQ(decision.asModelled, Verdict::Accept);
  EXPECT_EQ(decision.obstacle, Obstacle::Unexplained);
  EXPECT_EQ(decision.conformance, std::nullopt);
  EXPECT_EQ(at(0.5, &diagnosis).verdict, Verdict::Undecided);
}

// A failing closure alone decides nothing; the probability of an unexplained gap does.
TEST_F(Decision, DoesNotDependOnWhichCausesAreListed) {
  const Closure failing{Closure::Of::Centre, 0.65, 0.09, 1e-9};
  Diagnosis diagnosis = found("collimation", 1.3, 0.2);
  diagnosis.closures = {{failing, failing}};
  EXPECT_EQ(at(2.5, &diagnosis).verdict, Verdict::Accept);
}

// For a single account: 1.3 mm with U = 0.2 mm, σ = 0.102 mm. With an unexplained σ' the guard band is k √(σ²
// + σ'²), here 0.5 mm.
TEST_F(Decision, WidensTheGuardBandByWhatIsUnexplained) {
  constexpr double factor = 1.959963984540054;
  Diagnosis diagnosis = found("collimation", 1.3, 0.2);
  const double sigma = 0.2 / factor, together = 0.5 / factor;
  diagnosis.unexplained.sigma = std::sqrt(together * together - sigma * sigma);
  EXPECT_EQ(at(1.3 + 0.5 + 1e-6, &diagnosis).asFound, Verdict::Accept);
  EXPECT_EQ(at(1.3 + 0.5 - 1e-6, &diagnosis).asFound, Verdict::Undecided);
  EXPECT_EQ(at(1.3 - 0.5 - 1e-6, &diagnosis).asFound, Verdict::Reject);
  EXPECT_EQ(at(1.3 - 0.5 + 1e-6, &diagnosis).asFound, Verdict::Undecided);
  EXPECT_NEAR(*at(1.3 + 0.5, &diagnosis).conformance, 0.975, 1e-6);
}

// For any value, U, degrees of freedom and tolerance, one account decides like the guard band. So does an
// account that is split into two equal ones, which is decided by the risks.
TEST_F(Decision, IsTheGuardBandOfASingleAccount) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const double f = i % 3 == 0 ? std::numeric_limits<double>::infinity() : 1 + 40 * share(random);
    const double value = 4 * share(random) - 2, sigma = 0.5 * share(random) + 1e-3,
                 tolerance = 3 * share(random) + 1e-3;
    const double expanded = coverageFactor(measurement.coverage, f) * sigma;
    Diagnosis diagnosis;
    diagnosis.measured.emplace().estimate = {value, sigma, expanded, {{1, value, sigma}}, f};
    diagnosis.measured->budget = {{.effect = "plane_warp", .sigma = sigma}};
    const Verdict expected = decide(value, expanded, tolerance);
    EXPECT_EQ(at(tolerance, &diagnosis).asFound, expected) << i;
    diagnosis.measured->estimate.explanations = {{0.3, value, sigma}, {0.7, value, sigma}};
    EXPECT_EQ(at(tolerance, &diagnosis).asFound, expected) << i;
  }
}

// 4 % of the probability are far beyond the tolerance on one side, although ± U at 95 % is within it.
TEST_F(Decision, HeedsTheRiskOnEitherSide) {
  Diagnosis diagnosis = found("collimation", 0.9, 0.3);
  diagnosis.measured->estimate.explanations = {{96, 0.9, 0.1}, {4, 9, 0.1}};
  EXPECT_EQ(at(1.6, &diagnosis).asFound, Verdict::Undecided);
  diagnosis.measured->estimate.explanations = {{98, 0.9, 0.1}, {2, 9, 0.1}};
  EXPECT_EQ(at(1.6, &diagnosis).asFound, Verdict::Accept);
}

// An undetectable jump moves Δd = 1.3 mm by 0.4 mm (1σ). A tolerance of 2.5 mm allows for the jump, one of
// 1.6 mm does not. With a jump, Δd is normal with √(0.102² + 0.4²); 4 of 104 sessions have a jump.
TEST_F(Decision, StatesTheKnockThatItRestsOn) {
  Diagnosis diagnosis = found("collimation", 1.3, 0.2);
  diagnosis.undetectableJumps = {
      {.axisDeg = 180, .isAfterZero = true, .influence = 0.4, .moves = {{0.04, 0, 0.4}}},
      {.axisDeg = 0, .influence = 1e-3, .moves = {{0.001, 0, 1e-3}}}};
  EXPECT_THAT(at(2.5, &diagnosis).conditions, ::testing::IsEmpty());
  const AcceptanceDecision decision = at(1.6, &diagnosis);
  EXPECT_EQ(decision.verdict, Verdict::Accept);
  EXPECT_THAT(decision.conditions, ::testing::ElementsAre(0));
  const double sigma = 0.2 / 1.959963984540054, with = std::sqrt(sigma * sigma + 0.16);
  const auto within = [](double s) { return 0.5 * std::erfc(-0.3 / s / std::numbers::sqrt2); };
  EXPECT_NEAR(*decision.conformance, (1.001 * within(sigma) + 0.04 * within(with)) / 1.041, 1e-4);
  EXPECT_THAT(at(1.4, &diagnosis).conditions, ::testing::IsEmpty()) << "open in any case";
}

TEST_F(Decision, IsWithheldWithLengthsInDoubt) {
  measurement.nominalRadius = 250;
  const Diagnosis diagnosis = found("collimation", 0, 0.1);
  const AcceptanceDecision decision = at(2.5, &diagnosis);
  EXPECT_EQ(decision.verdict, Verdict::Undecided);
  EXPECT_EQ(decision.obstacle, Obstacle::Lengths);
  EXPECT_EQ(decision.conformance, std::nullopt);
}

// The fit knows the component of the distance in the plane, 1.308 ± 0.211 mm; the other one is across it:
// √(1.3² + 2²) = 2.385 mm.
TEST_F(Decision, OfTheDistanceFromTheAxisNeedsWhatLiesAcross) {
  measurement.measurand = Measurand::Distance;
  Diagnosis diagnosis = found("collimation", 1.3, 0.2);
  for (const Diagnosis* unmeasured : {static_cast<const Diagnosis*>(nullptr), &std::as_const(diagnosis)}) {
    EXPECT_EQ(at(2.5, unmeasured).verdict, Verdict::Undecided);
    EXPECT_EQ(at(2.5, unmeasured).obstacle, Obstacle::AcrossUnknown);
    EXPECT_EQ(at(2.5, unmeasured).conformance, std::nullopt);
    EXPECT_EQ(at(0.5, unmeasured).verdict, Verdict::Reject) << "too far off in the plane alone";
  }
  diagnosis.measured->across = MeasuredLength{2, 0.1, 0.2};
  diagnosis.measured->distance = MeasuredLength{2.385, 0.1, 0.2};
  EXPECT_EQ(at(2.6, &diagnosis).verdict, Verdict::Accept);
  EXPECT_EQ(at(2.5, &diagnosis).verdict, Verdict::Undecided);
  EXPECT_EQ(at(2.5, &diagnosis).obstacle, Obstacle::Uncertainty);
  EXPECT_EQ(at(2.1, &diagnosis).verdict, Verdict::Reject) << "though what the fit knows of it is within";
  EXPECT_EQ(at(2.1, &diagnosis).asModelled, Verdict::Accept);
  EXPECT_NEAR(*at(2.385, &diagnosis).conformance, 0.5, 0.02);
  measurement.measurand = Measurand::Intersection;
  EXPECT_EQ(at(2.1, &diagnosis).verdict, Verdict::Accept);
}

TEST_F(Decision, NeedsATolerance) {
  measurement.tolerance.reset();
  EXPECT_EQ(decideAcceptance(measurement, fitSession(measurement), nullptr), std::nullopt);
}

}  // namespace
}  // namespace alidade
