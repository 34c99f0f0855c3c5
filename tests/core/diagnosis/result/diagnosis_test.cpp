#include "core/diagnosis/result/diagnosis.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/diagnose.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

Cause cause(const std::string& effect, std::vector<std::string> group = {}) {
  Cause cause;
  cause.effect = effect;
  cause.indistinguishableFrom = std::move(group);
  return cause;
}

/// Two causes without look-alikes. U decreases with each step; `afterwards` equals the last step.
Diagnosis ofTwoCauses() {
  Diagnosis diagnosis;
  diagnosis.verdict = DiagnosisVerdict::SeveralCauses;
  diagnosis.causes = {cause("arc_lobing"), cause("collimation")};
  diagnosis.steps = {{"arc_lobing", {}, IntersectionEstimate{0.8, 0.04, 0.09}},
                     {"collimation", {}, IntersectionEstimate{0.7, 0.02, 0.05}}};
  diagnosis.before = IntersectionEstimate{1.1, 0.1, 0.2};
  diagnosis.afterwards = diagnosis.steps.back().intersection;
  return diagnosis;
}

// Truth files of others, and scripts that read results, use these words.
TEST(DiagnosisResult, CallsVerdictsAsFilesDo) {
  using enum DiagnosisVerdict;
  EXPECT_EQ(nameOf(WithinNoise), "within-noise");
  EXPECT_EQ(nameOf(SingleCause), "single-cause");
  EXPECT_EQ(nameOf(Ambiguous), "ambiguous");
  EXPECT_EQ(nameOf(SeveralCauses), "several-causes");
  EXPECT_EQ(nameOf(NotInCatalogue), "not-in-catalogue");
}

TEST(DiagnosisResult, HoldsNothingBeyondTheFitOfItsLastStep) {
  EXPECT_EQ(beyondTheFit({}), Beyond::Nothing);
  Diagnosis diagnosis = ofTwoCauses();
  EXPECT_EQ(beyondTheFit(diagnosis), Beyond::Nothing);
  diagnosis.afterwards = diagnosis.steps.front().intersection;
  EXPECT_EQ(beyondTheFit(diagnosis), Beyond::Others);
}

TEST(DiagnosisResult, IsAveragedOverOthersWhereUIsWider) {
  Diagnosis diagnosis = ofTwoCauses();
  diagnosis.afterwards->expanded += 1e-9;
  EXPECT_EQ(beyondTheFit(diagnosis), Beyond::Others);
}

// If one position is missing, there is no Δd.
TEST(DiagnosisResult, HoldsNothingBeyondTheFitWithoutAnIntersection) {
  Diagnosis diagnosis = ofTwoCauses();
  diagnosis.afterwards.reset();
  EXPECT_EQ(beyondTheFit(diagnosis), Beyond::Nothing);
  diagnosis = ofTwoCauses();
  diagnosis.steps.back().intersection.reset();
  EXPECT_EQ(beyondTheFit(diagnosis), Beyond::Nothing);
  diagnosis.steps.clear();
  EXPECT_EQ(beyondTheFit(diagnosis), Beyond::Nothing);
}

// Look-alikes of any cause count, whatever U; a pattern takes precedence over look-alikes.
TEST(DiagnosisResult, NamesLookAlikesOfAnyCauseAndThePatternFirst) {
  for (const std::size_t i : {0u, 1u}) {
    Diagnosis diagnosis = ofTwoCauses();
    diagnosis.causes[i].indistinguishableFrom = {"plane_warp"};
    EXPECT_EQ(beyondTheFit(diagnosis), Beyond::LookAlikes) << i;
    diagnosis.afterwards->expanded *= 2;
    EXPECT_EQ(beyondTheFit(diagnosis), Beyond::LookAlikes) << i;
    diagnosis.shape = GapShape{"radius along the guideway", 0.7};
    EXPECT_EQ(beyondTheFit(diagnosis), Beyond::Pattern) << i;
  }
}

double shareOfZeros(const Intersection& intersection) {
  for (const BudgetEntry& entry : intersection.budget)
    if (entry.source == UncertaintySource::PointingZeros) return entry.sigma;
  return 0;
}

// Sessions of an independent ray tracer without anything beyond the fit. A fit with the cause in the model
// gives the same result. It has a prior of one plausible size instead of three, and no closures. This changes
// Δd by less than a twentieth of U, and U by 5 %. Zeros of one mark cancel in Δd, while the fit refers each
// position to its own zero. With other causes U exceeds that of any fit, unless a form takes the gap off.
TEST(DiagnosisResult, HoldsNothingBeyondWhereAFitSaysTheSame) {
  std::array<int, 4> times{};
  for (const test::Trial& trial : test::trials()) {
    const Diagnosis diagnosis = *diagnose(trial.measurement);
    const Beyond beyond = beyondTheFit(diagnosis);
    ++times[static_cast<std::size_t>(beyond)];
    if (diagnosis.causes.size() > 1 || beyond == Beyond::LookAlikes || !diagnosis.forms.empty()) continue;
    const std::string named = diagnosis.causes.empty() ? "" : diagnosis.causes.front().effect;
    // An all-or-nothing effect is not estimated, and a session cannot name what is not an effect.
    if (!named.empty() && (!effectById(named) || named == relationId)) continue;
    SCOPED_TRACE(trial.id + " " + trial.kind);
    Measurement measurement = trial.measurement;
    if (!named.empty()) measurement.effects = {named};
    const Intersection fitted = *fitSession(measurement).intersection;
    if (beyond == Beyond::Nothing) {
      const double ofZeros = named.empty() ? 0 : fitted.coverageFactor * shareOfZeros(fitted);
      EXPECT_NEAR(diagnosis.afterwards->value, fitted.value, 0.05 * fitted.expanded + 2 * ofZeros);
      EXPECT_NEAR(std::hypot(diagnosis.afterwards->expanded, ofZeros), fitted.expanded,
                  0.05 * fitted.expanded);
    } else {
      EXPECT_GT(std::hypot(diagnosis.afterwards->expanded, fitted.coverageFactor * shareOfZeros(fitted)),
                1.01 * fitted.expanded);
    }
  }
  // Every uncatalogued gap among the trials has a form.
  for (const Beyond beyond : {Beyond::Nothing, Beyond::LookAlikes, Beyond::Others})
    EXPECT_GE(times[static_cast<std::size_t>(beyond)], 2);
  EXPECT_EQ(times[static_cast<std::size_t>(Beyond::Pattern)], 0);
}

}  // namespace
}  // namespace alidade
