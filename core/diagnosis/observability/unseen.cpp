#include "core/diagnosis/observability/unseen.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/candidates/jump_columns.h"
#include "core/diagnosis/candidates/known_components.h"
#include "core/diagnosis/observability/look_alikes.h"

namespace alidade {

using Eigen::Index, Eigen::VectorXd;

bool Detectability::isUndetectable() const {
  return influence > negligibleInfluence && visible < clearlyDifferent;
}

Detectability detectabilityOf(const Component& component, const VectorXd& influence) {
  Detectability detectability{component.id, influence.normalized(), influence.norm(), 0};
  if (detectability.influence == 0) return detectability;
  detectability.visible = std::sqrt(signatureSquare(component, detectability.weights));
  if (component.curvature.cols() == 0) return detectability;  // the opposite leaves as much
  const double opposite = std::sqrt(signatureSquare(component, -detectability.weights));
  if (opposite < detectability.visible) {
    detectability.weights = -detectability.weights;
    detectability.visible = opposite;
  }
  return detectability;
}

Detectability detectabilityOfEffect(const Leftover& leftover, const Component& component,
                                    const VectorXd& perReading) {
  return detectabilityOf(component, wholeColumns(leftover, component).transpose() * perReading);
}

std::vector<Detectability> undetectableEffects(const Leftover& leftover,
                                               const std::vector<Component>& candidates,
                                               const VectorXd& perReading) {
  std::vector<Detectability> unseen;
  const Eigen::Matrix2Xd ofJumps =
      JumpColumns(leftover, momentsOf(candidates), plausibleJump).products(perReading);
  Index jump = 0;
  for (const Component& component : candidates) {
    if (component.kind == Component::Kind::Shape || component.allOrNothing) continue;
    Detectability detectability = component.kind == Component::Kind::Jump
                                      ? detectabilityOf(component, ofJumps.col(jump++))
                                      : detectabilityOfEffect(leftover, component, perReading);
    if (!detectability.isUndetectable()) continue;
    const auto same = std::ranges::find(unseen, detectability.effect, &Detectability::effect);
    if (same == unseen.end())
      unseen.push_back(std::move(detectability));
    else if (same->influence < detectability.influence)
      *same = std::move(detectability);
  }
  std::ranges::sort(unseen, std::greater{}, &Detectability::influence);
  return unseen;
}

}  // namespace alidade
