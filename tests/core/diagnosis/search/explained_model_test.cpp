#include "core/diagnosis/search/explained_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/candidates/gross_error_components.h"
#include "core/diagnosis/candidates/jump_components.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

using Eigen::VectorXd;

/// A model, its leftover, and the candidates that may explain it.
struct Explainable {
  GapModel base;
  Leftover leftover{linearise(*base.measurement, *base.fit, base.options)};
  Candidates candidates = candidatesFor(base, leftover);

  static Candidates candidatesFor(const GapModel& base, const Leftover& leftover) {
    Candidates candidates;
    candidates.add(effectsBeyond(base, leftover, {}), 0.04);
    candidates.add(jumpComponents(leftover), 1e-3);
    candidates.add(grossErrorComponents(leftover), 1e-3);
    return candidates;
  }

  Part effect(std::string_view id, VectorXd weights) const {
    std::size_t i = 0;
    while (candidates[i].id() != id) ++i;
    return {.component = i, .width = 1, .weights = std::move(weights)};
  }
  Part grossError(const ReadingRef& ref) const {
    std::size_t i = 0;
    while (!candidates[i].grossErrorAt() || readingRef(leftover, *candidates[i].grossErrorAt()) != ref) ++i;
    return {.component = i, .width = 30, .weights = VectorXd::Constant(1, 20)};
  }
  Part jumpBefore(std::size_t row) const {
    std::size_t i = 0;
    while (!candidates[i].isJump() || !jumpsBefore(candidates[i], row)) ++i;
    return {.component = i, .width = 1, .weights = VectorXd::Ones(2)};
  }
  GapModel with(const Explanation& explanation) const {
    return modelWith(base, explanation, candidates, leftover);
  }

 private:
  static bool jumpsBefore(const Component& component, std::size_t row) {
    return static_cast<const JumpComponent&>(component).moment().first == row;
  }
};

double valueOf(const GapModel& model, ErrorTerm term) {
  return model.fit->values[model.fit->indexOf({.kind = Unknown::Kind::Error, .arc = 0, .term = term})];
}

/// A collimation, a warp, a jump before row 40 of 136 and one reading 200″ wrong, without noise.
Explainable perfectSession() {
  Truth truth = drawTruth(8);
  truth.effects = {{ErrorTerm::Collimation, 25}, {ErrorTerm::WarpCosine, 0.3}, {ErrorTerm::WarpSine, -0.2}};
  truth.jump = {
      .moment = 39.5 / 136, .horizontal = Angle::fromArcseconds(40), .vertical = Angle::fromArcseconds(-30)};
  truth.grossErrors = {{.axisDeg = 180,
                        .round = 1,
                        .point = 3,
                        .face = 2,
                        .horizontal = Angle::fromArcseconds(200),
                        .vertical = {}}};
  return {*modelOf(test::measurementOf(*simulateWithoutNoise(*protocolByName("full"), truth, 8)))};
}

// The prior draws a size of 1σ, visible by tens of σ, towards 0. The change is a few percent for a warp,
// which is visible by seven σ per plausible size, and less for the others.
TEST(ExplainedModel, GivesBackWhatASessionHolds) {
  const Explainable session = perfectSession();
  const ArcMeasurement& arc = session.base.measurement->arcs[1];
  const auto row = std::ranges::find_if(
      arc.sightings, [](const Sighting& s) { return s.round == 1 && s.point == 3 && s.face == 2; });
  const ReadingRef misread{1, static_cast<std::size_t>(row - arc.sightings.begin()), ReadingKind::Horizontal};
  std::vector<Part> parts{session.effect("collimation", VectorXd::Ones(1)),
                          session.effect("plane_warp", VectorXd::Zero(2)), session.jumpBefore(41),
                          session.grossError(misread)};
  const GapModel model = session.with({.parts = parts});
  ASSERT_TRUE(model.fit->converged());
  EXPECT_EQ(model.options.without, std::vector{misread});
  EXPECT_EQ(model.options.jumpBefore, 41u);  // with the zero before the rows
  const double second = Angle::fromArcseconds(1).radians();
  EXPECT_NEAR(valueOf(model, ErrorTerm::Collimation) / second, 25, 0.25);
  EXPECT_NEAR(valueOf(model, ErrorTerm::WarpCosine), 0.3, 0.03);
  EXPECT_NEAR(valueOf(model, ErrorTerm::WarpSine), -0.2, 0.03);
  EXPECT_NEAR(valueOf(model, ErrorTerm::HorizontalJump) / second, 40, 0.4);
  EXPECT_NEAR(valueOf(model, ErrorTerm::VerticalJump) / second, -30, 0.4);
  EXPECT_LT(model.fit->chiSquare, 10);  // from the priors: squared sizes in plausible sizes
  EXPECT_GT(session.base.fit->chiSquare, 1000);
  EXPECT_TRUE(session.base.options.terms.empty());
  EXPECT_EQ(model.measurement, session.base.measurement);

  std::ranges::reverse(parts);
  const GapModel reversed = session.with({.parts = parts});
  EXPECT_NEAR(reversed.fit->chiSquare, model.fit->chiSquare, 1e-9 * model.fit->chiSquare);
}

// A large size is not a misfit: the prior is as wide as the size found. With weights of 4 and 2 plausible
// sizes it is √10.
TEST(ExplainedModel, EstimatesInTheWidthOfTheParts) {
  const Explainable session = perfectSession();
  const GapModel model = session.with({.parts = {session.effect("plane_warp", Eigen::Vector2d(4, -2))}});
  ASSERT_EQ(model.options.terms.size(), 2u);
  EXPECT_NEAR(model.options.terms[0].priorSigma, 0.2 * std::sqrt(10), 1e-12);
  EXPECT_NEAR(model.options.terms[1].priorSigma, 0.2 * std::sqrt(10), 1e-12);
  EXPECT_NEAR(model.options.terms[0].start, 0.8, 1e-12);
  EXPECT_NEAR(model.options.terms[1].start, -0.4, 1e-12);
}

// One face without slider hardly determines the sign of a plane tilt, so the fit keeps the sign of its start.
// Circles and prior absorb half of its size.
TEST(ExplainedModel, StartsFromTheWeightsOfTheParts) {
  Truth truth = drawTruth(8);
  truth.effects = {{ErrorTerm::PlaneTiltX, 1.2}};
  const Explainable session{
      *modelOf(test::measurementOf(*simulateWithoutNoise(*protocolByName("paper"), truth, 8)))};
  for (const double side : {1.0, -1.0}) {
    const GapModel model =
        session.with({.parts = {session.effect("plane_tilt", Eigen::Vector2d(4 * side, 0))}});
    EXPECT_GT(valueOf(model, ErrorTerm::PlaneTiltX) * side, Angle::fromDegrees(0.4).radians()) << side;
  }
}

// By definition of its scale, noise gives χ² = f. Without redundancy it is unknown.
TEST(ExplainedModel, TakesForNoiseWhatScatters) {
  Truth truth = drawTruth(5);
  truth.noiseFactor = 3;
  Explainable noisy{*modelOf(test::measurementOf(*simulate(*protocolByName("paper"), truth, 5)))};
  noisy.base.noise = 1.5;
  EXPECT_EQ(noisy.with({}).noise, 1.5);
  const Explanation tilt{.parts = {noisy.effect("trunnion_tilt", VectorXd::Ones(1))}, .noisy = true};
  const GapModel model = noisy.with(tilt);
  EXPECT_EQ(model.options.terms.size(), 1u);
  EXPECT_NEAR(model.fit->chiSquare, model.fit->degreesOfFreedom, 1e-6);
  EXPECT_NEAR(model.noise / 1.5, 3, 4 * 3 / std::sqrt(2.0 * model.fit->degreesOfFreedom));  // four of its σ

  Measurement few = test::usualMeasurement();
  for (const int axisDeg : {0, 180})
    few.arcs.push_back(
        test::perfectArc(few, {0, 0, 400}, test::spread(3, 120, axisDeg == 0 ? 90 : -90), axisDeg));
  const Explainable open{*modelOf(few)};
  ASSERT_EQ(open.base.fit->degreesOfFreedom, 0);
  EXPECT_EQ(open.with({.parts = {}, .noisy = true}).noise, 1);
}

}  // namespace
}  // namespace alidade
