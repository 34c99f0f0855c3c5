#include "core/adjustment/intersection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/statistics.h"

namespace alidade {

namespace {

/// A scatter this improbably small is not trusted: the stated noise is taken instead.
constexpr double improbablySmall = 0.001;

double square(double value) {
  return value * value;
}

const ArcFit* arcAt(const std::vector<ArcFit>& arcs, int axisDeg) {
  const auto found = std::ranges::find(arcs, axisDeg, &ArcFit::axisDeg);
  return found == arcs.end() ? nullptr : &*found;
}

double component(const Measurement& measurement, const ArcFit& arc, double scale, std::size_t i) {
  return std::sqrt(square(scale) * arc.cofactor[i][i] +
                   square(arc.perHorizontalZero[i] * measurement.sigmaZeroHorizontal.radians()) +
                   square(arc.perVerticalZero[i] * measurement.sigmaZeroVertical.radians()) +
                   square(arc.perDistance[i] * measurement.sigmaDistance));
}

std::vector<BudgetEntry> budgetOf(const Measurement& measurement, const ArcFit& upper, const ArcFit& lower,
                                  double scale) {
  constexpr std::size_t y = 1;
  const double zeros = std::hypot(std::hypot(upper.perVerticalZero[y], lower.perVerticalZero[y]) *
                                      measurement.sigmaZeroVertical.radians(),
                                  std::hypot(upper.perHorizontalZero[y], lower.perHorizontalZero[y]) *
                                      measurement.sigmaZeroHorizontal.radians());
  const double distance = (upper.perDistance[y] - lower.perDistance[y]) * measurement.sigmaDistance;
  return {{"readings", scale * std::sqrt(upper.cofactor[y][y] + lower.cofactor[y][y]) / 2},
          {"pointing zeros", zeros / 2},
          {"distance", std::abs(distance) / 2}};
}

}  // namespace

NoiseScale noiseScale(const std::vector<ArcFit>& arcs) {
  double chiSquare = 0;
  int degreesOfFreedom = 0;
  for (const ArcFit& arc : arcs) {
    if (arc.degreesOfFreedom <= 0) continue;
    chiSquare += arc.chiSquare;
    degreesOfFreedom += arc.degreesOfFreedom;
  }
  constexpr double known = std::numeric_limits<double>::infinity();
  if (degreesOfFreedom == 0) return {1, known};
  if (1 - chiSquareUpperTail(chiSquare, degreesOfFreedom) < improbablySmall) return {1, known};
  return {std::sqrt(chiSquare / degreesOfFreedom), static_cast<double>(degreesOfFreedom)};
}

ArcSigma arcSigma(const Measurement& measurement, const ArcFit& arc, double scale) {
  return {component(measurement, arc, scale, 0), component(measurement, arc, scale, 1),
          component(measurement, arc, scale, 2)};
}

std::optional<Intersection> intersect(const Measurement& measurement, const std::vector<ArcFit>& arcs) {
  const ArcFit *upper = arcAt(arcs, 0), *lower = arcAt(arcs, 180);
  if (!upper || !lower) return std::nullopt;

  const NoiseScale noise = noiseScale(arcs);
  Intersection result;
  result.value = (upper->circle.y - lower->circle.y) / 2;
  result.inPlane = std::hypot(upper->circle.x - lower->circle.x, upper->circle.y - lower->circle.y) / 2;
  result.budget = budgetOf(measurement, *upper, *lower, noise.factor);
  double variance = 0;
  for (const BudgetEntry& entry : result.budget) variance += square(entry.sigma);
  result.sigma = std::sqrt(variance);
  const double readings = result.budget.front().sigma;
  result.effectiveDegreesOfFreedom = noise.degreesOfFreedom * square(variance / square(readings));
  result.coverage = measurement.coverage;
  result.coverageFactor = coverageFactor(result.coverage, result.effectiveDegreesOfFreedom);
  result.expanded = result.coverageFactor * result.sigma;
  return result;
}

}  // namespace alidade
