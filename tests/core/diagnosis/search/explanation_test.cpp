#include "core/diagnosis/search/explanation.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/search/inquiry.h"
#include "core/simulation/simulate.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

TEST(Explanation, IsSoughtNoFurtherOnceStopped) {
  const Measurement measurement = test::trialMeasurement("full");
  const Leftover leftover(linearise(measurement, fitSession(measurement).joint));
  Candidates candidates;
  candidates.add(effectComponents(leftover, {}), PriorOdds().effect);
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

/// ln of the density of N(0, covariance), without the term that depends only on the number of readings.
double logDensity(const Eigen::VectorXd& x, const Eigen::MatrixXd& covariance) {
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
  return -factor.matrixLLT().diagonal().array().log().sum() - 0.5 * factor.matrixL().solve(x).squaredNorm();
}

/// ln of the Bayes factor of a linear effect against none, from densities of all readings. With normal
/// weights of width σ the readings have the covariance 1 + σ² C Cᵀ; with the weight fixed at 1 they have the
/// mean C.
double logBayesFactor(const Leftover& leftover, const Component& effect) {
  const Eigen::VectorXd& readings = leftover.residual();
  const Eigen::MatrixXd columns = effect.visibleColumns(leftover);
  const Eigen::MatrixXd noise = Eigen::MatrixXd::Identity(readings.size(), readings.size());
  const double nothing = logDensity(readings, noise);
  if (effect.response() == Response::AllOrNothing) return logDensity(readings - columns, noise) - nothing;
  std::vector<double> terms;
  for (const Width& width : effect.widths())
    terms.push_back(width.logChance +
                    logDensity(readings, noise + width.sigma * width.sigma * columns * columns.transpose()) -
                    nothing);
  const double highest = *std::ranges::max_element(terms);
  double sum = 0;
  for (const double term : terms) sum += std::exp(term - highest);
  return highest + std::log(sum);
}

// The fit reproduces an effect of three plausible sizes in a perfect session. The prior draws it towards 0 by
// less than 3 % if it is visible by some ten σ; a plane tilt is bent.
TEST(FitAlone, GivesBackTheEffectThatASessionHolds) {
  for (const char* id : {"collimation", "trunnion_tilt", "plane_tilt", "arc_ellipticity", "vertical_drift"}) {
    SCOPED_TRACE(id);
    Truth truth = drawTruth(9);
    for (const EffectParameter& parameter : effectById(id)->parameters)
      truth.effects.push_back({parameter.term, 3 * parameter.plausible});
    const Session session = *simulateWithoutNoise(*protocolByName("full"), truth, 9);
    const GapModel model = *modelOf(*examine(session).measurement);
    const Leftover leftover(linearise(*model.measurement, *model.fit, model.options));
    const std::vector<EffectComponent> effects = effectsBeyond(model, leftover, {});
    const SharedProducts residual(leftover, leftover.residual());
    bool isFound = false;
    for (std::size_t i = 0; i < effects.size(); ++i) {
      const Part part = fitAlone(residual, effects[i], i);
      EXPECT_EQ(part.component, i);
      if (effects[i].response() != Response::Bent) {  // 1e-9 of its evidence
        const double evidence = logBayesFactor(leftover, effects[i]);
        EXPECT_NEAR(part.logGain, evidence, 1e-9 * (1 + std::abs(evidence))) << effects[i].id();
      }
      if (effects[i].id() != id) continue;
      isFound = true;
      for (const double weight : part.weights)  // the sign of a plane tilt is visible to second order only
        EXPECT_NEAR(std::string(id) == "plane_tilt" ? std::abs(weight) : weight, 3, 0.03 * 3);
    }
    EXPECT_TRUE(isFound);
  }
}

}  // namespace
}  // namespace alidade
