#include "core/diagnosis/observability/unseen.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/candidates/known_components.h"
#include "core/diagnosis/candidates/steps_in_time.h"
#include "core/diagnosis/observability/look_alikes.h"

namespace alidade {

using Eigen::Index, Eigen::VectorXd;

bool Danger::isUnseen() const {
  return influence > negligibleInfluence && visible < clearlyDifferent;
}

Danger dangerOf(const Component& component, const VectorXd& influence) {
  Danger danger{component.id, influence.normalized(), influence.norm(), 0};
  if (danger.influence == 0) return danger;
  danger.visible = std::sqrt(signatureSquare(component, danger.weights));
  if (component.curvature.cols() == 0) return danger;  // the opposite leaves as much
  const double opposite = std::sqrt(signatureSquare(component, -danger.weights));
  if (opposite < danger.visible) {
    danger.weights = -danger.weights;
    danger.visible = opposite;
  }
  return danger;
}

Danger dangerOfEffect(const Leftover& leftover, const Component& component, const VectorXd& perReading) {
  return dangerOf(component, wholeColumns(leftover, component).transpose() * perReading);
}

std::vector<Danger> unseenDangers(const Leftover& leftover, const std::vector<Component>& candidates,
                                  const VectorXd& perReading) {
  std::vector<Danger> unseen;
  const Eigen::Matrix2Xd ofJumps =
      StepsInTime(leftover, momentsOf(candidates), plausibleJump).products(perReading);
  Index jump = 0;
  for (const Component& component : candidates) {
    if (component.kind == Component::Kind::Shape || component.allOrNothing) continue;
    Danger danger = component.kind == Component::Kind::Jump ? dangerOf(component, ofJumps.col(jump++))
                                                            : dangerOfEffect(leftover, component, perReading);
    if (!danger.isUnseen()) continue;
    const auto same = std::ranges::find(unseen, danger.effect, &Danger::effect);
    if (same == unseen.end())
      unseen.push_back(std::move(danger));
    else if (same->influence < danger.influence)
      *same = std::move(danger);
  }
  std::ranges::sort(unseen, std::greater{}, &Danger::influence);
  return unseen;
}

}  // namespace alidade
