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

MatrixXd wholeColumns(const Leftover& leftover, const Measurement& measurement, const Component& component) {
  MatrixXd whole(leftover.readings(), component.columns.cols());
  if (component.kind == Component::Kind::Effect) {
    for (Index p = 0; p < whole.cols(); ++p) {
      const EffectParameter& parameter = component.effect->parameters[static_cast<std::size_t>(p)];
      whole.col(p) = leftover.column(parameter.term) * parameter.plausible * modelUnitsPer(parameter.unit);
    }
    return whole;
  }
  whole.col(0) = leftover.column(ErrorTerm::HorizontalJump) * plausibleJump;
  whole.col(1) = leftover.column(ErrorTerm::VerticalJump) * plausibleJump;
  for (Index i = 0; i < whole.rows(); ++i) {
    const LinearReading& reading = leftover.reading(i);
    if (measurement.arcs[reading.arc].sightings[reading.sighting].sequence < component.moment)
      whole.row(i).setZero();
  }
  return whole;
}

std::vector<UnseenEffect> unseenEffects(const Leftover& leftover, const std::vector<Component>& candidates,
                                        const Measurement& measurement, const VectorXd& perReading) {
  std::vector<UnseenEffect> unseen;
  for (const Component& component : candidates) {
    if (component.kind == Component::Kind::Shape || component.allOrNothing) continue;
    const UnseenEffect worst = worstOf(component, wholeColumns(leftover, measurement, component), perReading);
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
