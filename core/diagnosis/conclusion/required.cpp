#include "core/diagnosis/conclusion/required.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/diagnosis/candidates/jump_components.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// The least change of Δd, in mm, by a plausible size of an effect that could explain a difference: below, a
/// thousand plausible sizes explain less than 0.1 mm. It is smaller than `negligibleInfluence`, since the
/// size is free here.
constexpr double leastExplaining = 1e-4;

/// Among the weights that change Δd by `move` (mm), those with the smallest sum of two squares: the weights,
/// in plausible sizes, and their visible trace, in σ. They are not finite if no weight changes Δd.
VectorXd leastThatMoves(const Component& component, const VectorXd& influence, double move) {
  MatrixXd cost = component.gram().topLeftCorner(influence.size(), influence.size());
  cost.diagonal().array() += 1;
  const VectorXd direction = cost.ldlt().solve(influence);
  return direction * (move / influence.dot(direction));
}

/// By how many σ `weights` explain the readings worse than the best-fitting weights.
double excludedBy(const Component& component, const VectorXd& products, const VectorXd& weights,
                  double noise) {
  const MatrixXd gram = component.gram().topLeftCorner(weights.size(), weights.size());
  const VectorXd best = gram.completeOrthogonalDecomposition().solve(products);
  const auto gained = [&](const VectorXd& at) { return at.dot(2 * products - gram * at); };
  return std::sqrt(std::max(gained(best) - gained(weights), 0.0)) / noise;
}

Required requiredOf(const Component& component, const VectorXd& weights, const Measurement& measurement) {
  Required required;
  required.effect = component.id();
  const Effect* effect = effectById(component.id(), measurement);
  required.unit = effect ? effect->parameters.front().unit : "arcsec";
  const double unit = effect ? effect->parameters.front().plausible : plausibleJump / modelUnitsPer("arcsec");
  required.plausibleSizes = weights.norm();
  required.size = weights.norm() * unit;
  if (weights.size() == 1) required.size = weights[0] * unit;
  return required;
}

}  // namespace

std::vector<Required> whatItWouldTake(const Inquiry& inquiry) {
  std::vector<Required> list;
  const Measurement& measurement = *inquiry.own.measurement;
  const std::optional<IntersectionEstimate> own = estimateOf(inquiry.expected);
  if (!measurement.sigmaReference || !own) return list;
  const double move = own->value - *measurement.referenceIntersection;
  const VectorXd perReading = influencePerSigma(inquiry.base);
  const SharedProducts influences(inquiry.leftover, perReading),
      residual(inquiry.leftover, inquiry.leftover.residual());
  const double noise = inquiry.explanations.front().noise;
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    const Component& component = inquiry.candidates[i];
    const bool isEligible = component.isEffect() || component.wrongZeroArc();
    if (!isEligible || component.isKnown() || component.response() == Response::AllOrNothing) continue;
    const VectorXd influence = component.wholeProducts(influences);
    if (influence.norm() < leastExplaining) continue;
    const VectorXd weights = leastThatMoves(component, influence, move);
    const VectorXd products = component.products(residual).head(weights.size());
    if (excludedBy(component, products, weights, noise) > thresholds.clearlyDifferent) continue;
    Required required = requiredOf(component, weights, measurement);
    required.visibleSigma = component.signatureLength(weights);
    const auto same = std::ranges::find(list, required.effect, &Required::effect);
    if (same == list.end())
      list.push_back(std::move(required));
    else if (required.plausibleSizes < same->plausibleSizes)
      *same = std::move(required);
  }
  std::ranges::sort(list, {}, &Required::plausibleSizes);
  return list;
}

}  // namespace alidade
