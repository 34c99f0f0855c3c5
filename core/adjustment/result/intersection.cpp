#include "core/adjustment/result/intersection.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "core/adjustment/result/uncertain_length.h"
#include "core/base/square.h"
#include "core/base/statistics.h"
#include "core/observation/half_turn.h"

namespace alidade {

namespace {

struct Weight {
  std::size_t unknown = 0;
  double factor = 0;
};

/// A linear combination of the unknowns, without the zero weights: most are zero.
using Weights = boost::container::small_vector<Weight, 8>;

/// A budget with at most one entry for each source.
using Budget = boost::container::static_vector<BudgetEntry, 6>;

Weights partsOf(const std::vector<double>& weights) {
  Weights parts;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i] != 0) parts.push_back({i, weights[i]});
  return parts;
}

/// wᵀ Q w.
double quadraticForm(const SquareMatrix& matrix, const Weights& weights) {
  double sum = 0;
  for (const Weight& one : weights)
    for (const Weight& other : weights) sum += one.factor * matrix(one.unknown, other.unknown) * other.factor;
  return sum;
}

/// wᵀ Q e_u: the covariance with one of the unknowns.
double covarianceWith(const SquareMatrix& cofactor, const Weights& weights, std::size_t unknown) {
  double covariance = 0;
  for (const Weight& weight : weights) covariance += weight.factor * cofactor(weight.unknown, unknown);
  return covariance;
}

double ratePerConsidered(const JointFit& fit, const Weights& weights, std::size_t index) {
  double rate = 0;
  for (const Weight& weight : weights)
    rate += weight.factor * fit.perConsidered[weight.unknown * fit.considered.size() + index];
  return rate;
}

double varianceOfPrior(const JointFit& fit, const SquareMatrix& cofactor, const Weights& weights,
                       std::size_t unknown) {
  if (std::isinf(fit.priorSigmas[unknown])) return 0;
  return square(covarianceWith(cofactor, weights, unknown) / fit.priorSigmas[unknown]);
}

bool isTerm(const Unknown& unknown) {
  return unknown.kind == Unknown::Kind::Error;
}

/// The variance due to one kind of considered quantity.
double consideredVariance(const JointFit& fit, const Weights& weights, bool distance) {
  double variance = 0;
  for (std::size_t c = 0; c < fit.considered.size(); ++c) {
    if ((fit.considered[c].kind == Unknown::Kind::Distance) != distance) continue;
    variance += square(ratePerConsidered(fit, weights, c) * fit.consideredSigmas[c]);
  }
  return variance;
}

/// The variance due to unknowns of a kind with prior knowledge, such as a known radius.
template <typename Kind>
double varianceOfKnown(const JointFit& fit, const SquareMatrix& cofactor, const Weights& weights,
                       const Kind& isOfKind) {
  double variance = 0;
  for (std::size_t known = 0; known < fit.unknowns.size(); ++known)
    if (std::invoke(isOfKind, fit.unknowns[known]))
      variance += varianceOfPrior(fit, cofactor, weights, known);
  return variance;
}

bool isRadius(const Unknown& unknown) {
  return unknown.kind == Unknown::Kind::Radius;
}

bool isAny(const Unknown&) {
  return true;
}

/// The variance due to zeros that are observations.
double varianceOfSightedZeros(const JointFit& fit, const SquareMatrix& cofactor, const Weights& weights) {
  if (fit.zeroRows.empty()) return 0;
  std::vector<double> turned(fit.unknowns.size());
  for (std::size_t u = 0; u < turned.size(); ++u) turned[u] = covarianceWith(cofactor, weights, u);
  double variance = 0;
  for (const std::vector<double>& row : fit.zeroRows)
    variance += square(std::inner_product(row.begin(), row.end(), turned.begin(), 0.0));
  return variance;
}

/// The variance from readings at their stated σ.
double varianceOfReadings(const JointFit& fit, const SquareMatrix& cofactor, const Weights& weights) {
  const double known =
      varianceOfKnown(fit, cofactor, weights, isAny) + varianceOfSightedZeros(fit, cofactor, weights);
  // In this argument order max() passes NaN: an unknown variance must not become zero.
  return std::max(quadraticForm(cofactor, weights) - known, 0.0);
}

}  // namespace

std::vector<double> unitWeights(const JointFit& fit, const Unknown& unknown) {
  std::vector<double> weights(fit.unknowns.size());
  weights.at(fit.indexOf(unknown)) = 1;
  return weights;
}

std::optional<std::size_t> arcAt(const Measurement& measurement, int axisDeg) {
  const auto found = std::ranges::find(measurement.arcs, axisDeg, &ArcMeasurement::axisDeg);
  if (found == measurement.arcs.end()) return std::nullopt;
  return static_cast<std::size_t>(found - measurement.arcs.begin());
}

NoiseScale noiseScale(double chiSquare, int degreesOfFreedom) {
  constexpr double known = std::numeric_limits<double>::infinity();
  const NoiseScale asRead{std::sqrt(chiSquare / degreesOfFreedom), static_cast<double>(degreesOfFreedom)};
  // The median of χ² is below its mean f, so that a χ² above f is never improbably small.
  if (degreesOfFreedom > 0 && chiSquare >= degreesOfFreedom) return asRead;
  const std::optional<double> tail = chiSquareUpperTail(chiSquare, degreesOfFreedom);
  if (!tail || 1 - *tail < improbable) return {1, known};
  return asRead;
}

NoiseScale noiseScale(const JointFit& fit) {
  return noiseScale(fit.chiSquare, fit.degreesOfFreedom);
}

double covarianceWith(const SquareMatrix& cofactor, const std::vector<double>& weights, std::size_t unknown) {
  return covarianceWith(cofactor, partsOf(weights), unknown);
}

double ratePerConsidered(const JointFit& fit, const std::vector<double>& weights, std::size_t index) {
  return ratePerConsidered(fit, partsOf(weights), index);
}

double varianceOfPrior(const JointFit& fit, const SquareMatrix& cofactor, const std::vector<double>& weights,
                       std::size_t unknown) {
  return varianceOfPrior(fit, cofactor, partsOf(weights), unknown);
}

namespace {

Budget budgetOf(const JointFit& fit, const Weights& weights, double scale) {
  const double together = varianceOfReadings(fit, fit.cofactor, weights);
  const bool hasTerms = std::ranges::any_of(fit.unknowns, isTerm);
  const double withTermsKnown =
      hasTerms ? std::min(together, varianceOfReadings(fit, fit.cofactorWithoutTerms, weights)) : together;
  const auto estimated = [&](UncertaintySource source, double variance) {
    const double sigma = scale * standardDeviation(variance);
    return BudgetEntry{source, sigma, sigma};
  };
  Budget budget;
  budget.push_back(estimated(UncertaintySource::Readings, withTermsKnown));
  if (hasTerms) {
    budget.push_back(estimated(UncertaintySource::ModelEffects, together - withTermsKnown));
    budget.push_back(
        {UncertaintySource::PlausibleSizes, std::sqrt(varianceOfKnown(fit, fit.cofactor, weights, isTerm))});
  }
  const std::size_t radius = fit.indexOf({.kind = Unknown::Kind::Radius});
  if (radius < fit.unknowns.size() && !std::isinf(fit.priorSigmas[radius]))
    budget.push_back(
        {UncertaintySource::KnownRadius, std::sqrt(varianceOfKnown(fit, fit.cofactor, weights, isRadius))});
  const double ofZeros = std::sqrt(consideredVariance(fit, weights, false) +
                                   varianceOfKnown(fit, fit.cofactor, weights, &Unknown::isPointingZero) +
                                   varianceOfSightedZeros(fit, fit.cofactor, weights));
  const bool zerosScatter = fit.zerosAreReadings && scale > fit.zeroScatter;
  const double asTheyScatter = zerosScatter ? scale / fit.zeroScatter * ofZeros : ofZeros;
  budget.push_back({UncertaintySource::PointingZeros, asTheyScatter, zerosScatter ? asTheyScatter : 0});
  budget.push_back({UncertaintySource::Distance, std::sqrt(consideredVariance(fit, weights, true))});
  return budget;
}

double combined(const Budget& budget) {
  return combined(std::span(budget.data(), budget.size()));
}

/// Computes a covariance by polarisation: (var(a + b) − var(a − b))/4.
double covarianceOf(const JointFit& fit, const Weights& one, const Weights& other, double scale) {
  double covariance = 0;
  for (const double sign : {1.0, -1.0}) {
    Weights weights = one;
    for (const Weight& weight : other) {
      const auto same = std::ranges::find(weights, weight.unknown, &Weight::unknown);
      if (same == weights.end())
        weights.push_back({weight.unknown, sign * weight.factor});
      else
        same->factor += sign * weight.factor;
    }
    covariance += sign * square(combined(budgetOf(fit, weights, scale))) / 4;
  }
  return covariance;
}

Weights unitParts(const JointFit& fit, const Unknown& unknown) {
  return {{fit.indexOf(unknown), 1}};
}

std::vector<BudgetEntry> listed(const Budget& budget) {
  return {budget.begin(), budget.end()};
}

}  // namespace

std::vector<BudgetEntry> budgetOf(const JointFit& fit, const std::vector<double>& weights, double scale) {
  return listed(budgetOf(fit, partsOf(weights), scale));
}

double covarianceOf(const JointFit& fit, const std::vector<double>& one, const std::vector<double>& other,
                    double scale) {
  return covarianceOf(fit, partsOf(one), partsOf(other), scale);
}

double combined(std::span<const BudgetEntry> budget) {
  double variance = 0;
  for (const BudgetEntry& entry : budget) variance += square(entry.sigma);
  return std::sqrt(variance);
}

double scaledPart(std::span<const BudgetEntry> budget) {
  double variance = 0;
  for (const BudgetEntry& entry : budget) variance += square(entry.scaled);
  return std::sqrt(variance);
}

ArcBudget arcBudget(const JointFit& fit, std::size_t arc, double scale) {
  const auto budget = [&](Unknown::Kind kind) {
    return listed(budgetOf(fit, unitParts(fit, {.kind = kind, .arc = arc}), scale));
  };
  return {budget(Unknown::Kind::CentreX), budget(Unknown::Kind::CentreY), budget(Unknown::Kind::Radius)};
}

ArcSigma arcSigma(const JointFit& fit, std::size_t arc, double scale) {
  return arcSigma(fit, arc, scale, arcBudget(fit, arc, scale));
}

ArcSigma arcSigma(const JointFit& fit, std::size_t arc, double scale, const ArcBudget& budget) {
  ArcSigma result{combined(budget.x), combined(budget.y), combined(budget.radius)};
  const auto correlation = [&](Unknown::Kind kind, double sigmaOfKind) {
    const double covariance = covarianceOf(fit, unitParts(fit, {.kind = Unknown::Kind::Radius, .arc = arc}),
                                           unitParts(fit, {.kind = kind, .arc = arc}), scale);
    const double product = sigmaOfKind * result.radius;
    return product > 0 ? std::clamp(covariance / product, -1.0, 1.0) : 0;
  };
  result.radiusX = correlation(Unknown::Kind::CentreX, result.x);
  result.radiusY = correlation(Unknown::Kind::CentreY, result.y);
  return result;
}

std::vector<double> intersectionWeights(const JointFit& fit, std::size_t upper, std::size_t lower) {
  std::vector<double> weights(fit.unknowns.size());
  weights[fit.indexOf({.kind = Unknown::Kind::CentreY, .arc = upper})] = intersectionPerHeight(0);
  weights[fit.indexOf({.kind = Unknown::Kind::CentreY, .arc = lower})] = intersectionPerHeight(180);
  return weights;
}

namespace {

/// The weights of (O1 − O2)/2 along x; all zero in models in which both arcs share x.
std::vector<double> halfApartWeights(const JointFit& fit, std::size_t upper, std::size_t lower) {
  std::vector<double> weights(fit.unknowns.size());
  weights[fit.indexOf({.kind = Unknown::Kind::CentreX, .arc = upper})] += 0.5;
  weights[fit.indexOf({.kind = Unknown::Kind::CentreX, .arc = lower})] -= 0.5;
  return weights;
}

}  // namespace

std::optional<Intersection> intersect(const Measurement& measurement, const JointFit& fit) {
  return intersect(measurement, fit, noiseScale(fit));
}

std::optional<Intersection> intersect(const Measurement& measurement, const JointFit& fit,
                                      const NoiseScale& noise) {
  const auto upper = arcAt(measurement, 0), lower = arcAt(measurement, 180);
  if (!upper || !lower || !fit.isDetermined()) return std::nullopt;
  const auto index = [&](Unknown::Kind kind, std::size_t arc) {
    return fit.indexOf({.kind = kind, .arc = arc});
  };
  const auto difference = [&](Unknown::Kind kind) {
    return fit.values[index(kind, *upper)] - fit.values[index(kind, *lower)];
  };
  const std::vector<double> weights = intersectionWeights(fit, *upper, *lower);

  Intersection result;
  result.value = difference(Unknown::Kind::CentreY) / 2;
  result.budget = budgetOf(fit, weights, noise.factor);
  result.sigma = combined(result.budget);
  const DegreesOfFreedom effective =
      effectiveDegreesOfFreedom(result.sigma, scaledPart(result.budget), noise.degreesOfFreedom);
  result.effectiveDegreesOfFreedom = effective.count();
  result.coverage = measurement.coverage;
  result.coverageFactor = coverageFactor(result.coverage, effective);
  result.expanded = result.coverageFactor * result.sigma;
  const std::vector<double> along = halfApartWeights(fit, *upper, *lower);
  const UncertainLength apart = lengthOf({.x = difference(Unknown::Kind::CentreX) / 2,
                                          .y = result.value,
                                          .varianceX = square(combined(budgetOf(fit, along, noise.factor))),
                                          .varianceY = square(result.sigma),
                                          .covariance = covarianceOf(fit, along, weights, noise.factor)});
  result.inPlane = apart.value;
  result.inPlaneSigma = apart.sigma;
  result.inPlaneExpanded = result.coverageFactor * apart.sigma;
  return result;
}

}  // namespace alidade
