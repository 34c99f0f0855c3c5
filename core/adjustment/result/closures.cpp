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

std::optional<Misclosure> misclosureOf(const JointFit& fit, Closure::Of of, std::size_t at0,
                                       std::size_t at180, double scale) {
  const auto kind = of == Closure::Of::Radius ? Unknown::Kind::Radius : Unknown::Kind::CentreX;
  std::vector<double> weights(fit.unknowns.size());
  double value = 0;
  for (const auto& [arc, weight] : {std::pair(at180, 1.0), std::pair(at0, -1.0)}) {
    const auto own = std::ranges::find(fit.unknowns, Unknown{.kind = kind, .arc = arc});
    if (own == fit.unknowns.end()) return std::nullopt;
    const auto index = static_cast<std::size_t>(own - fit.unknowns.begin());
    weights[index] = weight;
    value += weight * fit.values[index];
  }
  const std::vector<BudgetEntry> budget = budgetOf(fit, weights, scale);
  return Misclosure{value, combined(budget), scaledPart(budget)};
}

std::vector<Closure> closuresOf(const Measurement& measurement, const JointFit& fit) {
  const auto upper = arcAt(measurement, 0), lower = arcAt(measurement, 180);
  if (!upper || !lower || !fit.isDetermined()) return {};
  const NoiseScale noise = noiseScale(fit);
  std::vector<Closure> closures;
  for (const Closure::Of of : {Closure::Of::Radius, Closure::Of::Centre}) {
    const auto misclosure = misclosureOf(fit, of, *upper, *lower, noise.factor);
    if (!misclosure) continue;
    Closure closure{.of = of, .value = misclosure->value, .sigma = misclosure->sigma};
    const DegreesOfFreedom freedom =
        effectiveDegreesOfFreedom(closure.sigma, misclosure->scaledSigma, noise.degreesOfFreedom);
    const auto below = studentLowerTail(-closure.sigmas(), freedom);
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
