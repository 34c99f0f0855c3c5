#include "core/diagnosis/conclusion/afterwards.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/adjustment/result/intersection.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/effects/cause_ids.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/support/timed.h"

namespace alidade {
namespace {

/// The posterior of Δd by brute force: no cause, a trunnion tilt, a vertical drift, or both. The sizes are on
/// a grid, and each is held in a fit of its own. The evidence is χ² of these fits, with the prior of the
/// diagnosis and the stated noise.
class Posterior {
 public:
  explicit Posterior(const Measurement& measurement) : m_base(*closedModelOf(*modelOf(measurement))) {
    addNode(1, {}, {});
    addOne(tilt);
    addOne(drift);
    addBoth();
  }

  /// Standard deviation of the posterior.
  double sigma() const {
    double all = 0, mean = 0, square = 0;
    for (const Node& node : m_nodes) {
      const double weight = node.weight * std::exp(-0.5 * (node.chiSquare - m_least));
      all += weight;
      mean += weight * node.value;
      square += weight * (node.value * node.value + node.sigma * node.sigma);
    }
    return std::sqrt(square / all - std::pow(mean / all, 2));
  }

  /// Posterior probability of the interval `value` ± U.
  double within(const IntersectionEstimate& estimate) const {
    double sum = 0, all = 0;
    for (const Node& node : m_nodes) {
      const double weight = node.weight * std::exp(-0.5 * (node.chiSquare - m_least));
      const auto below = [&](double x) {
        return std::erfc((node.value - x) / node.sigma / std::sqrt(2)) / 2;
      };
      sum += weight * (below(estimate.value + estimate.expanded) - below(estimate.value - estimate.expanded));
      all += weight;
    }
    return sum / all;
  }

 private:
  struct Size {
    ErrorTerm term;
    double plausible;  ///< arcseconds
  };
  struct Node {
    double weight, chiSquare, value, sigma;
  };
  static constexpr double odds = 0.04, reach = 4, step = 0.5;  // in σ of the sizes
  static constexpr Size tilt{ErrorTerm::TrunnionTilt, 30}, drift{ErrorTerm::VerticalDrift, 15};
  GapModel m_base;
  std::vector<Node> m_nodes;
  double m_least = std::numeric_limits<double>::infinity();

  static double unit(const Size& size) { return Angle::fromArcseconds(size.plausible).radians(); }

  /// Prior density of a size in plausible sizes: a mixture of normal ones with widths 0.1, 0.3, 1 and 3.
  static double prior(double size) {
    double sum = 0;
    for (const double width : {0.1, 0.3, 1.0, 3.0})
      sum += std::exp(-0.5 * std::pow(size / width, 2)) / width / std::sqrt(2 * std::numbers::pi) / 4;
    return sum;
  }

  /// Returns the fit with sizes held at `at`, or estimated if `at` is empty; all in plausible sizes.
  GapModel fitted(const std::vector<Size>& sizes, const std::vector<double>& at) const {
    constexpr double held = 1e-4, open = 1000;
    GapModel model = m_base;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const double value = at.empty() ? 0 : at[i] * unit(sizes[i]);
      model.options.terms.push_back(
          {sizes[i].term, (at.empty() ? open : held) * unit(sizes[i]), value, value});
    }
    model.refit();
    return model;
  }

  void addNode(double weight, const std::vector<Size>& sizes, const std::vector<double>& at) {
    const GapModel model = fitted(sizes, at);
    for (const double size : at) weight *= prior(size);
    const Intersection found = *intersect(*model.measurement, *model.fit);
    const double variance = influencePerSigma(model).squaredNorm();  // the zeros are readings too
    m_nodes.push_back({weight, model.fit->chiSquare, found.value, std::sqrt(variance)});
    m_least = std::min(m_least, model.fit->chiSquare);
  }

  static std::size_t indexOf(const JointFit& fit, const Size& size) {
    return fit.indexOf({.kind = Unknown::Kind::Error, .arc = 0, .term = size.term});
  }

  /// Adds sizes around the estimate.
  void addOne(const Size& size) {
    const JointFit fit = *fitted({size}, {}).fit;
    const std::size_t i = indexOf(fit, size);
    const double centre = fit.values[i] / unit(size), sigma = std::sqrt(fit.cofactor(i, i)) / unit(size);
    for (double u = -reach; u <= reach; u += step) addNode(odds * sigma * step, {size}, {centre + u * sigma});
  }

  /// Adds sizes along the principal axes of the estimate's uncertainty.
  void addBoth() {
    const JointFit fit = *fitted({tilt, drift}, {}).fit;
    const std::size_t i = indexOf(fit, tilt), j = indexOf(fit, drift);
    const double x = std::sqrt(fit.cofactor(i, i)) / unit(tilt);
    const double along = fit.cofactor(i, j) / (x * unit(tilt) * unit(drift));
    const double y = std::sqrt(fit.cofactor(j, j) / std::pow(unit(drift), 2) - along * along);
    for (double u = -reach; u <= reach; u += step)
      for (double v = -reach; v <= reach; v += step)
        addNode(odds * odds * x * y * step * step, {tilt, drift},
                {fit.values[i] / unit(tilt) + u * x, fit.values[j] / unit(drift) + u * along + v * y});
  }
};

/// Returns Δd with the named cause, and `afterwards` if only the two effects are considered.
std::pair<IntersectionEstimate, IntersectionEstimate> estimatesOf(const Measurement& measurement) {
  DiagnosisOptions options;
  for (const std::string& id : diagnosableEffects())
    if (id != "trunnion_tilt" && id != "vertical_drift") options.without.push_back(id);
  const Inquiry inquiry = inquire(*modelOf(measurement), options, {});
  const Answer answer = conclude(inquiry);
  return {*estimateOf(answer.after), *modelAveragedIntersection(inquiry, answer)};
}

// One pass in one face, with slider: a tilt and a drift are hard to separate. U may cover more than 95 % if
// kσ is larger. It may cover 2 % less, because it scales with the scatter of the readings, some 5 % different
// from the stated noise, and omits probabilities below 1 %.
TEST(Afterwards, HoldsTheCoverageOfWhatIsBelieved) {
  for (const auto& [arcsec, seed] : {std::pair{60.0, 2u}, {60.0, 5u}, {90.0, 5u}, {120.0, 3u}, {150.0, 6u}}) {
    Truth truth;
    truth.seed = seed;
    truth.intersection = 1.2;
    truth.effects = {{ErrorTerm::TrunnionTilt, arcsec}};
    const Measurement measurement =
        test::timed(*examine(*simulate(*protocolByName("paper-slider"), truth, seed)).measurement);
    const auto [alone, averaged] = estimatesOf(measurement);
    const Posterior posterior(measurement);
    EXPECT_GT(posterior.within(averaged), 0.93) << arcsec << ' ' << seed;
    EXPECT_GT(averaged.sigma, alone.sigma) << arcsec << ' ' << seed;
  }
}

// The drift is not a look-alike of a large tilt. But both together have a probability of a few percent, and
// then Δd differs. One side uses the stated noise, the other the observed scatter, which differ by some 5 %.
TEST(Afterwards, CountsWhatHasAChanceOfAFewPercent) {
  for (const auto& [arcsec, seed] : {std::pair{120.0, 5u}, {150.0, 3u}, {150.0, 11u}}) {
    Truth truth;
    truth.seed = seed;
    truth.intersection = 1.2;
    truth.effects = {{ErrorTerm::TrunnionTilt, arcsec}};
    const Measurement measurement =
        test::timed(*examine(*simulate(*protocolByName("paper-slider"), truth, seed)).measurement);
    const auto [alone, averaged] = estimatesOf(measurement);
    const Posterior posterior(measurement);
    EXPECT_GT(posterior.within(averaged), 0.93) << arcsec << ' ' << seed;
    EXPECT_NEAR(averaged.sigma, posterior.sigma(), 0.15 * posterior.sigma()) << arcsec << ' ' << seed;
  }
}

// Both faces, there and back, with slider: no other cause is likely, and Δd with the cause is that of its
// fit.
TEST(Afterwards, IsTheFitWithTheCauseWhereNothingElseMayBe) {
  Truth truth;
  truth.seed = 1;
  truth.intersection = 1.2;
  truth.effects = {{ErrorTerm::TrunnionTilt, 120}};
  const auto [alone, averaged] =
      estimatesOf(test::timed(*examine(*simulate(*protocolByName("full"), truth, truth.seed)).measurement));
  EXPECT_EQ(averaged.value, alone.value);
  EXPECT_EQ(averaged.expanded, alone.expanded);
}

}  // namespace
}  // namespace alidade
