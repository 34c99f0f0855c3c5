#include "core/diagnosis/plan_review.h"
#include "core/diagnosis/diagnose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/gap/gap_model.h"
#include "core/effects/catalogue.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using testing::Contains;
using testing::Each;
using testing::Field;
using testing::Not;

Measurement measurementBy(const std::string& protocol, const Truth& truth) {
  return *examine(*simulateWithoutNoise(*protocolByName(protocol), truth, 11)).measurement;
}

PlanReview reviewOf(const std::string& protocol) {
  return *reviewPlan(*examine(*simulate(*protocolByName(protocol), drawTruth(11), 11)).measurement);
}

const PlannedEffect& of(const PlanReview& review, const std::string& id) {
  return *std::ranges::find(review.effects, id, &PlannedEffect::effect);
}

/// A truth with the plausible size of one effect.
Truth withPlausible(const std::string& id) {
  Truth truth = drawTruth(11);
  for (const EffectParameter& parameter : effectById(id)->parameters)
    truth.effects.push_back({parameter.term, parameter.plausible});
  return truth;
}

/// Δd of one rigid guideway whose zeros sight one mark.
double closedIntersection(const Measurement& measurement) {
  const GapModel closed = *closedModelOf(*modelOf(measurement));
  return intersect(*closed.measurement, *closed.fit)->value;
}

// The reference for visibility and change of Δd are sessions with the effect at its plausible size. The
// review is linear in the effect: 2 %, and 0.01 σ and 0.3 µm for values near zero.
TEST(PlanReview, SeesWhatAnEffectDoes) {
  for (const char* protocol : {"paper", "full"}) {
    const PlanReview review = reviewOf(protocol);
    for (const char* id : {"collimation", "trunnion_tilt", "vertical_index", "horizontal_drift",
                           "vertical_drift", "gravity_sag", "plane_offset"}) {
      SCOPED_TRACE(std::string(protocol) + " " + id);
      const Measurement measurement = measurementBy(protocol, withPlausible(id));
      const PlannedEffect& effect = of(review, id);
      const double visible = visibilityOf(measurement, id)->sigma;
      EXPECT_NEAR(effect.mostVisible, visible, 0.02 * visible + 0.01);
      EXPECT_EQ(effect.leastVisible, effect.mostVisible);
      const double moved = std::abs(closedIntersection(measurement) -
                                    closedIntersection(measurementBy(protocol, drawTruth(11))));
      EXPECT_NEAR(effect.influence, moved, 0.02 * moved + 3e-4);
    }
  }
}

TEST(PlanReview, FindsWhatMovesTheIntersectionUnseen) {
  const PlanReview paper = reviewOf("paper"), full = reviewOf("full");
  for (const char* id : {"vertical_drift", "horizontal_circle_eccentricity"}) {
    EXPECT_TRUE(of(paper, id).undetectable) << id;
    EXPECT_FALSE(of(full, id).undetectable) << id;
  }
  EXPECT_GT(paper.intersection->sigma, full.intersection->sigma);
  EXPECT_GT(full.readings, paper.readings);
}

// The same plan and the same rule: both list the same undetectable effects. The noise of the readings moves
// the places on the arc by 1e-5 of the radius.
TEST(PlanReview, AgreesWithTheDiagnosisOnWhatIsUnseen) {
  for (const char* protocol : {"paper", "two-face"}) {
    const Measurement measurement =
        *examine(*simulate(*protocolByName(protocol), drawTruth(11), 11)).measurement;
    const PlanReview review = *reviewPlan(measurement);
    const Diagnosis diagnosis = *diagnose(measurement);
    std::vector<std::string> planned, diagnosed;
    for (const PlannedEffect& effect : review.effects)
      if (effect.undetectable) planned.push_back(effect.effect);
    for (const UndetectableEffect& undetectable : diagnosis.undetectable) {
      if (undetectable.effect == "orientation_jump") continue;  // not in the catalogue
      diagnosed.push_back(undetectable.effect);
      const PlannedEffect& effect = of(review, undetectable.effect);
      EXPECT_NEAR(undetectable.visibleSigma, effect.visibleThere, 0.01 * effect.visibleThere + 1e-3);
      EXPECT_NEAR(undetectable.influence, effect.influence, 0.01 * effect.influence);
      EXPECT_GT(undetectable.influence, 0.001) << "mm: less is not worth a word";
    }
    EXPECT_THAT(diagnosed, testing::UnorderedElementsAreArray(planned));
  }
}

// Physics of the set-up: a way back reveals the drifts; both faces and the slider separate the look-alikes of
// one face.
TEST(PlanReview, SaysWhatToAdd) {
  const PlanReview paper = reviewOf("paper");
  const auto advice = [&](Measure measure) -> const PlanAdvice& {
    return *std::ranges::find(paper.advice, std::vector{measure}, &PlanAdvice::measures);
  };
  EXPECT_THAT(advice(Measure::WayBack).reveals, Contains("vertical_drift"));
  EXPECT_THAT(advice(Measure::SliderReadings).reveals, Contains("plane_tilt"));
  EXPECT_THAT(advice(Measure::SliderReadings).separates,
              Contains(testing::Pair("plane_offset", "plane_warp")));
  for (const Measure measure : {Measure::At0Again, Measure::WayBack})
    EXPECT_THAT(advice(measure).separates, Contains(testing::Pair("horizontal_drift", "axial_shift")));
  // No single measure clarifies as much as all together.
  EXPECT_THAT(paper.advice.front().measures,
              testing::UnorderedElementsAre(Measure::BothFaces, Measure::WayBack, Measure::SliderReadings));
  const PlanReview full = reviewOf("full");
  for (const PlanAdvice& more : full.advice)
    EXPECT_THAT(more.measures, Each(testing::AllOf(Not(Measure::BothFaces), Not(Measure::WayBack),
                                                   Not(Measure::SliderReadings))));
}

// The paper's readings contain an unexplained gap; the plan is independent of the readings.
TEST(PlanReview, HangsOnThePlanAndNotOnTheReadings) {
  Measurement spoiled = test::paperMeasurement();
  const PlanReview clean = *reviewPlan(spoiled);
  for (ArcMeasurement& arc : spoiled.arcs)
    for (Sighting& sighting : arc.sightings)
      sighting.e = sighting.e + Angle::fromArcseconds(sighting.point % 2 ? 20 : -20);
  const PlanReview review = *reviewPlan(spoiled);
  for (std::size_t i = 0; i < clean.effects.size(); ++i)
    EXPECT_NEAR(review.effects[i].mostVisible, clean.effects[i].mostVisible,
                0.01 * clean.effects[i].mostVisible + 0.01);
}

TEST(PlanReview, FailsInWords) {
  Measurement empty = test::paperMeasurement();
  empty.arcs.clear();
  EXPECT_FALSE(reviewPlan(empty));
}

}  // namespace
}  // namespace alidade
