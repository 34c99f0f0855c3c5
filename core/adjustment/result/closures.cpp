#include "core/adjustment/result/closures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "core/adjustment/joint/sighted_zeros.h"
#include "core/adjustment/result/intersection.h"
#include "core/base/square.h"
#include "core/base/statistics.h"

namespace alidade {

namespace {

Misclosure combinationOf(const JointFit& fit, const std::vector<double>& weights, double scale) {
  const double value = std::inner_product(weights.begin(), weights.end(), fit.values.begin(), 0.0);
  const std::vector<BudgetEntry> budget = budgetOf(fit, weights, scale);
  return {value, combined(budget), scaledPart(budget)};
}

/// Returns the mean radius of all arcs.
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
    case Closure::Of::Repeat:
      return "repeat";
    case Closure::Of::Reference:
      return "reference";
    case Closure::Of::ZeroAzimuth:
    case Closure::Of::ZeroElevation:
      return "zeros";
  }
  return "";
}

Closure closureOf(Closure::Of of, double value, double sigma, double degreesOfFreedom) {
  Closure closure{.of = of, .value = value, .sigma = sigma};
  const auto below = studentLowerTail(-closure.sigmas(), degreesOfFreedom);
  closure.chance = below ? 2 * *below : 1;
  return closure;
}

std::optional<Misclosure> misclosureOf(const JointFit& fit, Unknown::Kind quantity, std::size_t first,
                                       std::size_t other, double scale) {
  std::vector<double> weights(fit.unknowns.size());
  for (const auto& [arc, weight] : {std::pair(other, 1.0), std::pair(first, -1.0)}) {
    const auto own = std::ranges::find(fit.unknowns, Unknown{.kind = quantity, .arc = arc});
    if (own == fit.unknowns.end()) return std::nullopt;
    weights[static_cast<std::size_t>(own - fit.unknowns.begin())] = weight;
  }
  return combinationOf(fit, weights, scale);
}

namespace {

/// The closure of a misclosure minus the value `known`, whose σ is `sigma`.
Closure closureOf(Closure::Of of, const Misclosure& misclosure, const NoiseScale& noise, double known = 0,
                  double sigma = 0) {
  const double together = std::hypot(misclosure.sigma, sigma);
  return closureOf(
      of, misclosure.value - known, together,
      effectiveDegreesOfFreedom(together, misclosure.scaledSigma, noise.degreesOfFreedom).count());
}

}  // namespace

std::vector<Closure> closuresOf(const Measurement& measurement, const JointFit& fit) {
  if (!fit.isDetermined() || fit.unknowns.empty()) return {};
  const NoiseScale noise = noiseScale(fit);
  std::vector<Closure> closures;
  const auto upper = arcAt(measurement, 0), lower = arcAt(measurement, 180);
  if (upper && lower)
    for (const auto& [of, quantity] : {std::pair(Closure::Of::Radius, Unknown::Kind::Radius),
                                       std::pair(Closure::Of::Centre, Unknown::Kind::CentreX)})
      if (const auto misclosure = misclosureOf(fit, quantity, *upper, *lower, noise.factor))
        closures.push_back(closureOf(of, *misclosure, noise));
  if (measurement.sigmaRadius > 0 && measurement.radiusModel != RadiusModel::Known)
    closures.push_back(closureOf(Closure::Of::NominalRadius, meanRadius(fit, noise.factor), noise,
                                 measurement.nominalRadius, measurement.sigmaRadius));
  if (upper && lower && measurement.sigmaReference) {
    const std::vector<double> weights = intersectionWeights(fit, *upper, *lower);
    closures.push_back(closureOf(Closure::Of::Reference, combinationOf(fit, weights, noise.factor), noise,
                                 *measurement.referenceIntersection, *measurement.sigmaReference));
  }
  return closures;
}

std::optional<JointFit> fitApart(const Measurement& measurement, const std::vector<Circle>& starts,
                                 JointFitOptions options) {
  if (!hasRepeats(measurement)) return std::nullopt;
  options.isClosed = false;
  options.isApart = true;
  JointFit fit = fitJointly(measurement, starts, options);
  if (!fit.converged()) return std::nullopt;
  return fit;
}

std::vector<Closure> repeatsOf(const Measurement& measurement, const JointFit& apart) {
  using enum Unknown::Kind;
  const NoiseScale noise = noiseScale(apart);
  const std::vector<std::size_t> firsts = firstAtTheirAxes(measurement);
  std::vector<Closure> closures;
  for (std::size_t arc = 0; arc < firsts.size(); ++arc)
    for (const Unknown::Kind quantity : {CentreX, CentreY, Radius}) {
      if (firsts[arc] == arc) continue;
      const auto misclosure = misclosureOf(apart, quantity, firsts[arc], arc, noise.factor);
      if (!misclosure) continue;
      closures.push_back(closureOf(Closure::Of::Repeat, *misclosure, noise));
      closures.back().repeated = {measurement.arcs[arc].axisDeg, measurement.arcs[arc].repeat, quantity};
    }
  return closures;
}

namespace {

/// The share of an arc's zero sightings on which the jump acts, 0…1.
double jumpShare(const ArcMeasurement& arc, const JointFitOptions& options) {
  if (!options.jumpBefore || arc.zeroSightings.empty()) return 0;
  const auto after = std::ranges::count_if(arc.zeroSightings, [&](const SightedZero& zero) {
    return zero.order >= *options.jumpBefore && (!options.jumpEnd || zero.order < *options.jumpEnd);
  });
  return static_cast<double>(after) / static_cast<double>(arc.zeroSightings.size());
}

}  // namespace

std::vector<Closure> zeroClosuresOf(const Measurement& measurement, const JointFit& fit,
                                    const JointFitOptions& options) {
  constexpr double exact = std::numeric_limits<double>::infinity();
  std::vector<Closure> closures;
  if (measurement.hasOneZero() || !fit.isDetermined() || measurement.arcs.empty()) return closures;
  const CommonZeros common = commonZeros(measurement);
  const auto sizeOf = [&](ErrorTerm term) {
    const std::size_t index = fit.indexOf(term);
    return index < fit.values.size() ? fit.values[index] : 0;
  };
  const ArcMeasurement& first = measurement.arcs.front();
  const auto add = [&](Closure::Of of, const ArcMeasurement& later, double angle, Angle sigma,
                       Angle sigmaFirst) {
    const double together = std::hypot(sigma.radians(), sigmaFirst.radians());
    if (!(together > 0)) return;
    closures.push_back(closureOf(of, measurement.distance * angle, measurement.distance * together, exact));
    closures.back().repeated = {later.axisDeg, later.repeat, Unknown::Kind::CentreX};
  };
  const double down = measurement.verticalCircle == VerticalCircle::Zenith ? 1 : -1;
  for (const ArcMeasurement& later : measurement.arcs) {
    if (&later == &first) continue;
    const double elapsed = later.zero.elapsed - first.zero.elapsed,
                 jumped = jumpShare(later, options) - jumpShare(first, options);
    const double turned =
        sizeOf(ErrorTerm::HorizontalDrift) * elapsed + sizeOf(ErrorTerm::HorizontalJump) * jumped;
    const double raised =
        -down * (sizeOf(ErrorTerm::VerticalDrift) * elapsed + sizeOf(ErrorTerm::VerticalJump) * jumped);
    if (common.horizontal)
      add(Closure::Of::ZeroAzimuth, later,
          wrapped(later.zeroHorizontal - first.zeroHorizontal).radians() - turned,
          measurement.sigmaOfZeroHorizontal(later), measurement.sigmaOfZeroHorizontal(first));
    if (common.vertical)
      add(Closure::Of::ZeroElevation, later, (later.zeroElevation - first.zeroElevation).radians() - raised,
          measurement.sigmaOfZeroVertical(later), measurement.sigmaOfZeroVertical(first));
  }
  return closures;
}

bool fails(const Closure& closure) {
  return closure.chance < improbable;
}

}  // namespace alidade
