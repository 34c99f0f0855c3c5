#include "core/adjustment/result/closures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
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

Misclosure combinationOf(const JointFit& fit, const std::vector<double>& weights, double scale) {
  const double value = std::inner_product(weights.begin(), weights.end(), fit.values.begin(), 0.0);
  const std::vector<BudgetEntry> budget = budgetOf(fit, weights, scale);
  return {value, combined(budget), scaledPart(budget)};
}

/// Of all arcs.
Misclosure meanRadius(const JointFit& fit, double scale) {
  const auto isRadius = [](const Unknown& unknown) { return unknown.kind == Unknown::Kind::Radius; };
  const auto count = static_cast<double>(std::ranges::count_if(fit.unknowns, isRadius));
  std::vector<double> weights;
  for (const Unknown& unknown : fit.unknowns) weights.push_back(isRadius(unknown) ? 1 / count : 0);
  return combinationOf(fit, weights, scale);
}

}  // namespace

std::string_view nameOf(Closure::Of of) {
  switch (of) {
    case Closure::Of::Radius:
      return "radius";
    case Closure::Of::Centre:
      return "centre";
    case Closure::Of::NominalRadius:
      return "nominal_radius";
    case Closure::Of::Reference:
      return "reference";
  }
  return "";
}

Closure closureOf(Closure::Of of, double value, double sigma, double degreesOfFreedom) {
  Closure closure{.of = of, .value = value, .sigma = sigma};
  const auto below = studentLowerTail(-closure.sigmas(), degreesOfFreedom);
  closure.chance = below ? 2 * *below : 1;
  return closure;
}

std::optional<Misclosure> misclosureOf(const JointFit& fit, Closure::Of of, std::size_t at0,
                                       std::size_t at180, double scale) {
  const auto kind = of == Closure::Of::Radius ? Unknown::Kind::Radius : Unknown::Kind::CentreX;
  std::vector<double> weights(fit.unknowns.size());
  for (const auto& [arc, weight] : {std::pair(at180, 1.0), std::pair(at0, -1.0)}) {
    const auto own = std::ranges::find(fit.unknowns, Unknown{.kind = kind, .arc = arc});
    if (own == fit.unknowns.end()) return std::nullopt;
    weights[static_cast<std::size_t>(own - fit.unknowns.begin())] = weight;
  }
  return combinationOf(fit, weights, scale);
}

std::vector<Closure> closuresOf(const Measurement& measurement, const JointFit& fit) {
  if (!fit.isDetermined() || fit.unknowns.empty()) return {};
  const NoiseScale noise = noiseScale(fit);
  std::vector<Closure> closures;
  /// Held against `known`, with its σ.
  const auto add = [&](Closure::Of of, const Misclosure& misclosure, double known, double sigma) {
    const double together = std::hypot(misclosure.sigma, sigma);
    closures.push_back(closureOf(
        of, misclosure.value - known, together,
        effectiveDegreesOfFreedom(together, misclosure.scaledSigma, noise.degreesOfFreedom).count()));
  };
  const auto upper = arcAt(measurement, 0), lower = arcAt(measurement, 180);
  if (upper && lower)
    for (const Closure::Of of : {Closure::Of::Radius, Closure::Of::Centre})
      if (const auto misclosure = misclosureOf(fit, of, *upper, *lower, noise.factor))
        add(of, *misclosure, 0, 0);
  if (measurement.sigmaRadius > 0 && measurement.radiusModel != RadiusModel::Known)
    add(Closure::Of::NominalRadius, meanRadius(fit, noise.factor), measurement.nominalRadius,
        measurement.sigmaRadius);
  if (upper && lower && measurement.sigmaReference) {
    const std::vector<double> weights = intersectionWeights(fit, *upper, *lower);
    add(Closure::Of::Reference, combinationOf(fit, weights, noise.factor), *measurement.referenceIntersection,
        *measurement.sigmaReference);
  }
  return closures;
}

bool fails(const Closure& closure) {
  constexpr double risk = 0.001;
  return closure.chance < risk;
}

}  // namespace alidade
