#include "core/diagnosis/explanation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/session_fit.h"
#include "core/diagnosis/gain.h"
#include "core/diagnosis/inquiry.h"
#include "core/diagnosis/known_components.h"
#include "core/simulation/simulate.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

TEST(Explanation, IsSoughtNoFurtherOnceStopped) {
  const Measurement measurement = test::trialMeasurement("full");
  const Leftover leftover({linearise(measurement, fitSession(measurement).joint)});
  const std::vector<Component> candidates = effectComponents(leftover, {}, {});
  std::stop_source stop;
  const auto longest = [&] {
    std::size_t most = 0;
    for (const Explanation& found : explain(leftover, candidates, {.stop = stop.get_token()}))
      most = std::max(most, found.parts.size());
    return most;
  };
  EXPECT_GT(longest(), 0U);
  stop.request_stop();
  EXPECT_EQ(longest(), 0U);
}

/// ln of the evidence for the effect against that for nothing.
double logEvidence(const Leftover& leftover, const Component& effect) {
  const bool isBent = effect.curvature.cols() > 0;
  const Eigen::MatrixXd columns = isBent ? bentColumns(effect) : effect.columns;
  const Eigen::VectorXd right = columns.transpose() * leftover.residual();
  if (isBent) return fitBent(widthsOf(effect.kind), columns.transpose() * columns, right, 1).gain.log;
  if (effect.allOrNothing) return right[0] - columns.squaredNorm() / 2;
  return gainOf(widthsOf(effect.kind), effect.gram, right, 1).log;
}

// A perfect session that holds three plausible sizes of an effect gives them back, drawn to 0 by the prior of
// their width by less than 3 % where they show by some ten σ; a plane tilt bends.
TEST(FitAlone, GivesBackTheEffectThatASessionHolds) {
  for (const char* id : {"collimation", "trunnion_tilt", "plane_tilt", "arc_ellipticity", "vertical_drift"}) {
    SCOPED_TRACE(id);
    Truth truth = drawTruth(9);
    for (const EffectParameter& parameter : effectById(id)->parameters)
      truth.effects.push_back({parameter.term, 3 * parameter.plausible});
    const Session session = *simulateWithoutNoise(*protocolByName("full"), truth, 9);
    const GapModel model = *modelOf(*examine(session).measurement);
    const Leftover leftover({linearise(model.measurement, model.fit, model.options)});
    const std::vector<Component> effects = effectsBeyond(model, leftover, {}, {});
    bool isFound = false;
    for (std::size_t i = 0; i < effects.size(); ++i) {
      const Part part = fitAlone(leftover, effects[i], i);
      EXPECT_EQ(part.component, i);
      EXPECT_DOUBLE_EQ(part.logGain, logEvidence(leftover, effects[i])) << effects[i].id;
      if (effects[i].id != id) continue;
      isFound = true;
      for (const double weight : part.weights)  // a tilt of the plane shows its sign to second order only
        EXPECT_NEAR(std::string(id) == "plane_tilt" ? std::abs(weight) : weight, 3, 0.03 * 3);
    }
    EXPECT_TRUE(isFound);
  }
}

}  // namespace
}  // namespace alidade
