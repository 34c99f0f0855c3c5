#include "core/diagnosis/conformance.h"

#include <algorithm>
#include <cmath>

#include "core/base/square.h"
#include "core/base/statistics.h"

namespace alidade {

std::optional<double> conformanceOf(const IntersectionEstimate& estimate, double tolerance, double shift) {
  double within = 0, all = 0;
  for (const NormalPart& explanation : estimate.explanations) {
    const auto below = [&](double limit) {
      return studentLowerTail((limit - shift - explanation.mean) / explanation.sigma,
                              estimate.degreesOfFreedom);
    };
    const std::optional<double> high = below(tolerance), low = below(-tolerance);
    if (!high || !low) return std::nullopt;
    within += explanation.share * (*high - *low);
    all += explanation.share;
  }
  if (!(all > 0)) return std::nullopt;
  return std::clamp(within / all, 0.0, 1.0);  // removes rounding errors
}

std::optional<TailRisk> tailRiskOf(const IntersectionEstimate& estimate, double tolerance) {
  TailRisk risk;
  double all = 0;
  for (const NormalPart& explanation : estimate.explanations) {
    const auto beyond = [&](double mean) {
      return studentLowerTail((mean - tolerance) / explanation.sigma, estimate.degreesOfFreedom);
    };
    const std::optional<double> above = beyond(explanation.mean), below = beyond(-explanation.mean);
    if (!above || !below) return std::nullopt;
    risk.above += explanation.share * *above;
    risk.below += explanation.share * *below;
    all += explanation.share;
  }
  if (!(all > 0)) return std::nullopt;
  risk.above /= all;
  risk.below /= all;
  return risk;
}

IntersectionEstimate widened(IntersectionEstimate estimate, double sigma) {
  if (!(sigma > 0)) return estimate;
  const double factor = estimate.sigma > 0 ? std::hypot(estimate.sigma, sigma) / estimate.sigma : 1;
  estimate.sigma *= factor;
  estimate.expanded *= factor;
  for (NormalPart& explanation : estimate.explanations)
    explanation.sigma = std::hypot(explanation.sigma, sigma);
  return estimate;
}

std::optional<double> conformanceOf(const IntersectionEstimate& inPlane, const MeasuredLength& across,
                                    double tolerance) {
  constexpr int steps = 1000;  // equally probable values of Δz; the sum is accurate to 0.1 %
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double rank = (2.0 * i + 1) / steps - 1;  // −1…1
    const double quantile =
        rank == 0 ? 0 : std::copysign(coverageFactor(std::abs(rank), inPlane.degreesOfFreedom), rank);
    const double z = across.value + across.sigma * quantile;
    if (!(std::abs(z) < tolerance)) continue;
    const auto within = conformanceOf(inPlane, std::sqrt(square(tolerance) - square(z)));
    if (!within) return std::nullopt;
    sum += *within;
  }
  return sum / steps;
}

std::optional<double> greatestRisk(const IntersectionEstimate& estimate, double tolerance) {
  double greatest = 0;
  const auto within = [&](double edge) { return conformanceOf(estimate, tolerance, edge - estimate.value); };
  for (const double side : {-1.0, 1.0}) {
    const auto accepted = within(side * (tolerance - estimate.expanded)),
               rejected = within(side * (tolerance + estimate.expanded));
    if (!accepted || !rejected) return std::nullopt;
    if (estimate.expanded <= tolerance) greatest = std::max(greatest, 1 - *accepted);
    greatest = std::max(greatest, *rejected);
  }
  return greatest;
}

}  // namespace alidade
