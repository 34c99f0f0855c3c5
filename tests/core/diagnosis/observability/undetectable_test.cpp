#include "core/diagnosis/observability/undetectable.h"
#include "core/diagnosis/candidates/effect_components.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/diagnosis/search/inquiry.h"
#include "core/diagnosis/visibility.h"
#include "core/simulation/simulate.h"

namespace alidade {
namespace {

Measurement measurementBy(const std::string& protocol, const std::string& effect,
                          const Eigen::VectorXd& weights) {
  Truth truth = drawTruth(11);
  const std::vector<EffectParameter>& parameters = effectById(effect)->parameters;
  for (std::size_t p = 0; p < parameters.size(); ++p)
    truth.effects.push_back(
        {parameters[p].term, weights[static_cast<Eigen::Index>(p)] * parameters[p].plausible});
  return *examine(*simulateWithoutNoise(*protocolByName(protocol), truth, 11)).measurement;
}

double intersectionOf(const Measurement& measurement) {
  return fitSession(measurement).intersection->value;
}

class Undetectable : public ::testing::TestWithParam<const char*> {
 protected:
  GapModel model = *modelOf(measurementBy(GetParam(), "plane_tilt", Eigen::Vector2d::Zero()));
  Leftover leftover{{linearise(*model.measurement, *model.fit, model.options)}};
  std::vector<EffectComponent> effects = effectsBeyond(model, leftover, {});
  Eigen::VectorXd influence = influencePerSigma(model);
  SharedProducts perReading{leftover, influence};

  const EffectComponent& find(const std::string& id) const {
    return *std::ranges::find(effects, id, &EffectComponent::id);
  }
};

// The references for visibility and change of Δd are sessions that contain the effect. Without slider
// readings, a plane tilt is visible to second order only, and its two signs differ. Third-order terms are 3 %
// and 0.002 σ. The influence is of first order: the second order of 0.3° is some R²/L tan² 0.3° = 2 µm.
TEST_P(Undetectable, EffectsShowAndMoveTheIntersectionAsSessionsThatHoldThem) {
  const double clean = intersectionOf(*model.measurement);
  for (const char* id : {"plane_tilt", "horizontal_circle_eccentricity", "vertical_drift", "plane_warp"}) {
    SCOPED_TRACE(std::string(GetParam()) + " " + id);
    const Detectability detectability = detectabilityOf(find(id), perReading);
    ASSERT_NEAR(detectability.weights.norm(), 1, 1e-12);
    const Measurement held = measurementBy(GetParam(), id, detectability.weights);
    const double visible = visibilityIn(*modelOf(held), id).sigma;
    EXPECT_NEAR(detectability.visible, visible, 0.03 * visible + 0.002);
    EXPECT_NEAR(detectability.influence, std::abs(intersectionOf(held) - clean),
                0.03 * detectability.influence + 2e-3);
    const Measurement opposite = measurementBy(GetParam(), id, -detectability.weights);
    EXPECT_GE(visibilityIn(*modelOf(opposite), id).sigma, 0.97 * detectability.visible - 0.002);
  }
}

// An index error is equal in all readings of one face and in the zeros, so Δd does not change.
TEST_P(Undetectable, WhatDoesNotMoveTheIntersectionIsNoDanger) {
  const Detectability detectability = detectabilityOf(find("vertical_index"), perReading);
  EXPECT_LT(detectability.influence, thresholds.negligibleInfluence);
  EXPECT_FALSE(detectability.isUndetectable());
  Candidates candidates;
  candidates.add(effects, PriorOdds().effect);
  for (const Detectability& undetectable : undetectableEffects(leftover, candidates, influence)) {
    EXPECT_NE(undetectable.effect, "vertical_index");
    EXPECT_GT(undetectable.influence, thresholds.negligibleInfluence);
  }
}

INSTANTIATE_TEST_SUITE_P(OneFaceAndTwo, Undetectable, ::testing::Values("paper", "paper-slider", "two-face"));

}  // namespace
}  // namespace alidade
