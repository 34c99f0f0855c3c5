#include "core/diagnosis/candidates/known_components.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/diagnosis/candidates/jump_columns.h"
#include "core/diagnosis/candidates/second_derivatives.h"
#include "core/effects/cause_ids.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

std::vector<Component> effectComponents(const Leftover& leftover, const std::vector<std::string>& leftOut,
                                        const PriorOdds& odds) {
  std::vector<Component> components;
  Index count = 0;
  for (const Effect& effect : effectCatalogue()) {
    if (std::ranges::find(leftOut, effect.id) != leftOut.end()) continue;
    components.push_back(
        {.kind = Component::Kind::Effect, .id = effect.id, .source = effect.source, .effect = &effect});
    count += static_cast<Index>(effect.parameters.size());
  }
  MatrixXd columns(leftover.readings(), count);
  Index first = 0;
  for (const Component& component : components)
    for (const EffectParameter& parameter : component.effect->parameters)
      columns.col(first++) = leftover.column(parameter.term) * plausibleSize(parameter);
  columns = leftover.visible(columns);
  first = 0;
  for (Component& component : components) {
    const auto own = columns.middleCols(first, static_cast<Index>(component.effect->parameters.size()));
    component.gram = own.transpose().lazyProduct(own);
    component.logPrior = std::log(odds.effect);
    component.allOrNothing = component.effect->response == Response::AllOrNothing;
    first += own.cols();
  }
  return components;
}

std::vector<Component> effectsBeyond(const GapModel& model, const Leftover& leftover,
                                     const std::vector<std::string>& leftOut, const PriorOdds& odds) {
  std::vector<Component> components = effectComponents(leftover, leftOut, odds);
  for (Component& component : components) {
    if (component.effect->response != Response::Bent) continue;
    component.curvature = leftover.visible(secondDerivatives(model, leftover, *component.effect));
    const Eigen::MatrixXd columns = visibleColumns(leftover, component);
    component.bentGram = columns.transpose() * columns;
  }
  return components;
}

namespace {

void sortAsSet(std::vector<std::size_t>& values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Moments whose step parts a row alone in its visit from the rest of its position, as its first or its last:
/// all that could be seen of it is the one condition between the two circles of that row.
std::map<std::size_t, std::size_t> rowsThatAloneShow(const Leftover& leftover) {
  std::map<std::size_t, std::vector<std::size_t>> rowsOfArc;
  std::vector<std::size_t> alone;
  for (Index v = 0; v < leftover.visits(); ++v) {
    const Leftover::Run visit = leftover.readingsOf(v);
    for (Index i = visit.first; i < visit.end; ++i) {
      const LinearReading& reading = leftover.reading(i);
      rowsOfArc[reading.arc].push_back(reading.sequence);
      if (visit.length() == 2) alone.push_back(reading.sequence);
    }
  }
  const auto isAlone = [&](std::size_t row) { return std::ranges::find(alone, row) != alone.end(); };
  std::map<std::size_t, std::size_t> rows;
  for (auto& [arc, own] : rowsOfArc) {
    sortAsSet(own);
    if (own.size() < 2) continue;
    if (isAlone(own.back())) rows.emplace(own.back(), own.back());
    if (isAlone(own.front())) rows.emplace(own[1], own.front());
  }
  return rows;
}

}  // namespace

std::vector<Component> jumpComponents(const Leftover& leftover, const PriorOdds& odds) {
  constexpr std::size_t mostMoments = 400;
  std::vector<std::size_t> moments;
  for (Index i = 0; i < leftover.readings(); ++i) moments.push_back(leftover.reading(i).sequence);
  sortAsSet(moments);
  if (moments.size() < 3) return {};
  moments.erase(moments.begin());  // before the first row there is no step
  const std::map<std::size_t, std::size_t> shownByOne = rowsThatAloneShow(leftover);
  const std::size_t stride = moments.size() / mostMoments + 1;
  std::vector<Component> components;
  components.reserve(moments.size() / stride + 1);
  for (std::size_t m = 0; m < moments.size(); m += stride) {
    components.push_back(
        {.kind = Component::Kind::Jump, .id = jumpId, .source = ErrorSource::Time, .moment = moments[m]});
    const auto only = shownByOne.find(moments[m]);
    if (only != shownByOne.end()) components.back().onlyRow = only->second;
  }
  const auto grams = JumpColumns(leftover, momentsOf(components), plausibleJump).visibleGrams();
  for (std::size_t m = 0; m < components.size(); ++m) components[m].gram = grams[m];
  const double logPrior = std::log(odds.jump / static_cast<double>(components.size()));
  for (Component& component : components) component.logPrior = logPrior;
  return components;
}

std::vector<std::size_t> momentsOf(const std::vector<Component>& components) {
  std::vector<std::size_t> moments;
  for (const Component& component : components)
    if (component.kind == Component::Kind::Jump) moments.push_back(component.moment);
  return moments;
}

}  // namespace alidade
