#include "core/diagnosis/observability/unseen.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/observability/look_alikes.h"

namespace alidade {

using Eigen::VectorXd;

bool Detectability::isUndetectable() const {
  return influence > negligibleInfluence && visible < clearlyDifferent;
}

Detectability detectabilityOf(const Component& component, const SharedProducts& perReading) {
  const VectorXd sizes = component.usualSizes();
  const VectorXd influence = component.wholeProducts(perReading).cwiseProduct(sizes);
  Detectability detectability{component.id(), influence.normalized().cwiseProduct(sizes), influence.norm(),
                              0};
  if (detectability.influence == 0) return detectability;
  detectability.visible = component.signatureLength(detectability.weights);
  if (component.response() != Response::Bent) return detectability;  // the opposite leaves as much
  const double opposite = component.signatureLength(-detectability.weights);
  if (opposite < detectability.visible) {
    detectability.weights = -detectability.weights;
    detectability.visible = opposite;
  }
  return detectability;
}

std::vector<Detectability> undetectableEffects(const Leftover& leftover, const Candidates& candidates,
                                               const VectorXd& perReading) {
  std::vector<Detectability> unseen;
  const SharedProducts influence(leftover, perReading);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Component& component = candidates[i];
    const bool isNamed = component.isEffect() || component.isJump();
    if (!isNamed || component.response() == Response::AllOrNothing) continue;
    Detectability detectability = detectabilityOf(component, influence);
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
