#include "core/diagnosis/unseen.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/known_components.h"
#include "core/diagnosis/look_alikes.h"
#include "core/diagnosis/steps_in_time.h"

namespace alidade {

using Eigen::Index, Eigen::VectorXd;

namespace {

/// In the direction of the weights that moves Δd most.
UnseenEffect worstOf(const Component& component, const VectorXd& influence) {
  const double size = influence.norm();
  if (size < negligibleInfluence) return {component.id, 0, std::sqrt(component.gram.trace())};
  const VectorXd direction = influence / size;
  return {component.id, size, std::sqrt(std::max(0.0, direction.dot(component.gram * direction)))};
}

}  // namespace

std::vector<UnseenEffect> unseenEffects(const Leftover& leftover, const std::vector<Component>& candidates,
                                        const VectorXd& perReading) {
  std::vector<UnseenEffect> unseen;
  const Eigen::Matrix2Xd ofJumps =
      StepsInTime(leftover, momentsOf(candidates), plausibleJump).products(perReading);
  Index jump = 0;
  for (const Component& component : candidates) {
    if (component.kind == Component::Kind::Shape || component.allOrNothing) continue;
    const VectorXd influence = component.kind == Component::Kind::Jump
                                   ? VectorXd(ofJumps.col(jump++))
                                   : wholeColumns(leftover, component).transpose() * perReading;
    const UnseenEffect worst = worstOf(component, influence);
    if (worst.influence < negligibleInfluence || worst.visibleSigma > clearlyDifferent) continue;
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
