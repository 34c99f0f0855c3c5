#include "core/diagnosis/unseen.h"

#include <algorithm>
#include <numbers>

#include "core/diagnosis/look_alikes.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double negligible = 1e-5;  // mm

UnseenEffect worstOf(const Component& component, const MatrixXd& whole, const VectorXd& perReading) {
  const VectorXd influence = whole.transpose() * perReading;
  const double size = influence.norm();
  if (size < negligible) return {component.id, 0, component.columns.norm()};
  return {component.id, size, (component.columns * (influence / size)).norm()};
}

}  // namespace

std::vector<UnseenEffect> unseenEffects(const Leftover& leftover, const std::vector<Component>& candidates,
                                        const VectorXd& perReading) {
  std::vector<UnseenEffect> unseen;
  for (const Component& component : candidates) {
    if (component.kind == Component::Kind::Shape || component.allOrNothing) continue;
    const UnseenEffect worst = worstOf(component, wholeColumns(leftover, component), perReading);
    if (worst.influence < negligible || worst.visibleSigma > clearlyDifferent) continue;
    const auto same = std::ranges::find(unseen, worst.effect, &UnseenEffect::effect);
    if (same == unseen.end())
      unseen.push_back(worst);
    else if (same->influence < worst.influence)
      *same = worst;
  }
  std::ranges::sort(unseen, std::greater{}, &UnseenEffect::influence);
  return unseen;
}

}  // namespace alidade
