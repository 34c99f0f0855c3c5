#include "core/diagnosis/candidates/effect_components.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "core/diagnosis/candidates/second_derivatives.h"
#include "core/diagnosis/evidence/bent_fit.h"
#include "core/effects/known_sizes.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

const std::vector<Width>& effectWidths() {
  static const std::vector<Width> widths = evenly({0.1, 0.3, 1, 3});
  return widths;
}

EffectComponent::EffectComponent(const Effect& effect, MatrixXd gram)
    : m_effect(&effect),
      m_response(effect.response == Response::Bent ? Response::Linear : effect.response),
      m_gram(std::move(gram)) {}

void EffectComponent::bend(const Leftover& leftover, MatrixXd secondDerivatives) {
  m_response = Response::Bent;
  m_secondDerivatives = std::move(secondDerivatives);
  const MatrixXd columns = visibleColumns(leftover);
  m_gram = columns.transpose() * columns;
}

const std::vector<Width>& EffectComponent::widths() const {
  return effectWidths();
}

MatrixXd EffectComponent::wholeColumns(const Leftover& leftover) const {
  MatrixXd columns(leftover.readings(), weights());
  Index column = 0;
  for (const EffectParameter& parameter : m_effect->parameters)
    columns.col(column++) = leftover.column(parameter.term) * plausibleSize(parameter);
  return columns;
}

MatrixXd EffectComponent::visibleColumns(const Leftover& leftover) const {
  MatrixXd columns = Component::visibleColumns(leftover);
  const Index bent = m_secondDerivatives.cols();
  if (bent == 0) return columns;
  columns.conservativeResize(Eigen::NoChange, columns.cols() + bent);
  columns.rightCols(bent) = m_secondDerivatives;
  return columns;
}

void EffectComponent::fillProducts(const SharedProducts& with, Eigen::Ref<VectorXd> own) const {
  Index column = 0;
  for (const EffectParameter& parameter : m_effect->parameters)
    own[column++] = with.ofTerms()[static_cast<Index>(parameter.term)] * plausibleSize(parameter);
  const Index bent = m_secondDerivatives.cols();
  if (bent > 0) own.tail(bent) = m_secondDerivatives.transpose() * with.vector();
}

VectorXd EffectComponent::signature(const Leftover& leftover, const VectorXd& weights) const {
  VectorXd signature = Component::signature(leftover, weights);
  if (m_response == Response::Bent) signature += m_secondDerivatives * bentWeights(weights).tail<3>();
  return signature;
}

void EffectComponent::addTo(JointFitOptions& model, const Leftover&, const VectorXd& weights,
                            double width) const {
  if (m_response == Response::AllOrNothing) {
    constexpr double whole = 1, exactly = 1e-6;
    model.terms.push_back({m_effect->parameters[0].term, exactly, whole, whole});
    return;
  }
  Index weight = 0;
  for (const EffectParameter& parameter : m_effect->parameters) {
    const double unit = plausibleSize(parameter), beyond = weights[weight++] * unit;
    const auto known = std::ranges::find(model.terms, parameter.term, &EstimatedTerm::term);
    if (known == model.terms.end()) {
      model.terms.push_back({parameter.term, width * unit, 0, beyond});
      continue;
    }
    known->start = known->priorValue + beyond;
    known->priorSigma = std::hypot(known->priorSigma, width * unit);
  }
}

std::vector<CauseParameter> EffectComponent::parameters(const GapModel& after) const {
  std::vector<CauseParameter> parameters;
  for (const EffectParameter& parameter : m_effect->parameters)
    parameters.push_back(estimatedParameter(after, parameter.name, parameter.term, parameter.unit));
  return parameters;
}

namespace {

/// Adds the components of `effects`. Their columns, `count` in all, are projected together.
void addComponents(const Leftover& leftover, std::span<const Effect* const> effects, Index count,
                   std::vector<EffectComponent>& components) {
  MatrixXd columns(leftover.readings(), count);
  Index first = 0;
  for (const Effect* effect : effects)
    for (const EffectParameter& parameter : effect->parameters)
      columns.col(first++) = leftover.column(parameter.term) * plausibleSize(parameter);
  columns = leftover.visible(columns);
  first = 0;
  for (const Effect* effect : effects) {
    const auto own = columns.middleCols(first, static_cast<Index>(effect->parameters.size()));
    components.emplace_back(*effect, own.transpose().lazyProduct(own));
    first += own.cols();
  }
}

}  // namespace

std::vector<EffectComponent> effectComponents(const Leftover& leftover,
                                              const std::vector<std::string>& leftOut,
                                              const Measurement& measurement) {
  std::vector<const Effect*> effects = effectsOf(measurement);
  std::erase_if(effects, [&](const Effect* effect) {
    return !effect->isSought || std::ranges::find(leftOut, effect->id) != leftOut.end();
  });
  std::vector<EffectComponent> components;
  constexpr Index mostNumbers = 4'000'000;  // at a time: all columns of a large session fill the memory
  const Index most = mostNumbers / std::max(leftover.readings(), Index{1});
  for (auto next = effects.begin(); next != effects.end();) {
    const auto first = next;
    Index count = 0;
    do count += static_cast<Index>((*next++)->parameters.size());
    while (next != effects.end() && count < most);
    addComponents(leftover, {first, next}, count, components);
  }
  return components;
}

namespace {

bool isInModel(const GapModel& model, const Effect& effect) {
  return std::ranges::all_of(effect.parameters, [&](const EffectParameter& parameter) {
    const auto& terms = model.options.terms;
    return std::ranges::find(terms, parameter.term, &EstimatedTerm::term) != terms.end();
  });
}

void markKnown(EffectComponent& component, const GapModel& model) {
  const Effect& effect = component.effect();
  const std::optional<std::vector<KnownPrior>> known = knownOf(*model.measurement, effect);
  if (!known || !isInModel(model, effect)) return;
  VectorXd sigmas(component.weights());
  for (Index i = 0; i < sigmas.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    sigmas[i] = (*known)[at].sigma / plausibleSize(effect.parameters[at]);
  }
  component.setKnown(std::move(sigmas));
}

}  // namespace

std::vector<EffectComponent> effectsBeyond(const GapModel& model, const Leftover& leftover,
                                           const std::vector<std::string>& leftOut) {
  std::vector<EffectComponent> components = effectComponents(leftover, leftOut, *model.measurement);
  for (EffectComponent& component : components) {
    if (component.effect().response == Response::Bent)
      component.bend(leftover, leftover.visible(secondDerivatives(model, leftover, component.effect())));
    markKnown(component, model);
  }
  return components;
}

}  // namespace alidade
