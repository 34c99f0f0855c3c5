#include "core/adjustment/result/closures.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/adjustment/result/intersection.h"
#include "core/base/square.h"
#include "core/base/statistics.h"

namespace alidade {

namespace {

/// The root of the variance that is known by the scatter only.
double scaledPart(const std::vector<BudgetEntry>& budget) {
  double variance = 0;
  for (const BudgetEntry& entry : budget)
    if (entry.source == UncertaintySource::Readings || entry.source == UncertaintySource::ModelEffects)
      variance += square(entry.sigma);
  return std::sqrt(variance);
}

}  // namespace

std::string_view nameOf(Closure::Of of) {
  return of == Closure::Of::Radius ? "radius" : "centre";
}

std::vector<Closure> closuresOf(const Measurement& measurement, const JointFit& fit) {
  const auto upper = arcAt(measurement, 0), lower = arcAt(measurement, 180);
  if (!upper || !lower || !fit.isDetermined()) return {};
  const NoiseScale noise = noiseScale(fit);
  std::vector<Closure> closures;
  for (const auto& [of, kind] : {std::pair(Closure::Of::Radius, Unknown::Kind::Radius),
                                 std::pair(Closure::Of::Centre, Unknown::Kind::CentreX)}) {
    const auto at0 = std::ranges::find(fit.unknowns, Unknown{.kind = kind, .arc = *upper});
    const auto at180 = std::ranges::find(fit.unknowns, Unknown{.kind = kind, .arc = *lower});
    if (at0 == fit.unknowns.end() || at180 == fit.unknowns.end()) continue;
    const auto i = static_cast<std::size_t>(at0 - fit.unknowns.begin()),
               j = static_cast<std::size_t>(at180 - fit.unknowns.begin());
    std::vector<double> weights(fit.unknowns.size());
    weights[i] = -1;
    weights[j] = 1;
    const std::vector<BudgetEntry> budget = budgetOf(fit, weights, noise.factor);
    Closure closure{.of = of, .value = fit.values[j] - fit.values[i], .sigma = combined(budget)};
    const DegreesOfFreedom freedom =
        effectiveDegreesOfFreedom(closure.sigma, scaledPart(budget), noise.degreesOfFreedom);
    const auto below = studentLowerTail(-std::abs(closure.value) / closure.sigma, freedom);
    closure.chance = below ? 2 * *below : 1;
    closures.push_back(closure);
  }
  return closures;
}

bool fails(const Closure& closure) {
  constexpr double risk = 0.001;
  return closure.chance < risk;
}

}  // namespace alidade
