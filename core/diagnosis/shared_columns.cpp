#include "core/diagnosis/shared_columns.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/diagnosis/candidates/session_patterns.h"

namespace alidade {

namespace {

bool isSame(const OwnEffect& a, const OwnEffect& b) {
  return a.id == b.id && a.formula == b.formula && a.turnsWithFace == b.turnsWithFace &&
         std::ranges::equal(a.parameters, b.parameters, [](const OwnParameter& p, const OwnParameter& q) {
           return p.name == q.name && p.plausible == q.plausible;
         });
}

}  // namespace

SharedColumns::SharedColumns(const std::vector<std::shared_ptr<const OwnEffects>>& own) {
  for (const Effect* effect : soughtEffects())
    add({effect, 0, effect->response == Response::Bent ? 5 : effect->parameters.size()});
  addOwn(own);
  m_effects = m_all.size();
  m_effectColumns = m_starts.size();
  for (const SessionPattern& pattern : sessionPatterns())
    add({&pattern.effect, 0, static_cast<std::size_t>(pattern.columns), true, pattern.order});
  std::size_t products = 0;
  for (std::size_t i = 0; i < m_starts.size(); ++i) {
    const std::size_t inPattern = i - m_starts[i].first;
    m_starts[i].products = products;
    products += i < m_effectColumns ? i + 1 : m_effectColumns + inPattern + 1;
  }
}

void SharedColumns::addOwn(const std::vector<std::shared_ptr<const OwnEffects>>& own) {
  constexpr std::size_t mostColumns = 24;  // the products of all columns are kept for each session
  std::vector<std::pair<std::size_t, const OwnEntry*>> counted;
  for (const auto& effects : own) {
    if (!effects) continue;
    m_kept.push_back(effects);
    for (const OwnEntry& entry : effects->entries()) {
      const auto known = std::ranges::find_if(
          counted, [&](const auto& other) { return isSame(other.second->source, entry.source); });
      if (known == counted.end())
        counted.emplace_back(1, &entry);
      else
        ++known->first;
    }
  }
  std::ranges::stable_sort(counted, std::greater{}, [](const auto& one) { return one.first; });
  const std::size_t before = m_starts.size();
  for (const auto& [sessions, entry] : counted)
    if (sessions > 1 && m_starts.size() - before + entry->terms.size() <= mostColumns)
      add({&entry->effect, 0, entry->terms.size(), false, 0, entry});
}

void SharedColumns::add(EffectColumns columns) {
  columns.first = m_starts.size();
  m_starts.insert(m_starts.end(), columns.count, {0, columns.first});
  m_all.push_back(columns);
}

const EffectColumns* SharedColumns::of(std::string_view id, const OwnEffects* own) const {
  const auto found = std::ranges::find_if(effects(), [&](const EffectColumns& columns) {
    if (columns.effect->id != id) return false;
    return !columns.own || (own && std::ranges::any_of(own->entries(), [&](const OwnEntry& entry) {
                              return isSame(entry.source, columns.own->source);
                            }));
  });
  return found == effects().end() ? nullptr : &*found;
}

std::size_t SharedColumns::productAt(std::size_t a, std::size_t b) const {
  const auto [column, row] = std::minmax(a, b);
  return m_starts[row].products +
         (column < m_effectColumns ? column : m_effectColumns + column - m_starts[row].first);
}

}  // namespace alidade
