#include "core/series/history/quantity_history.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace alidade {

void FoundQuantities::add(const std::string& id, const std::string& unit, const DatedValue& value) {
  if (!(value.u > 0) || !std::isfinite(value.u) || !std::isfinite(value.value)) return;
  auto place = std::ranges::find(m_found, id, &Quantity::id);
  if (place == m_found.end()) place = m_found.insert(place, {id, unit, {}});
  place->values.push_back(value);
}

std::optional<std::string> FoundQuantities::unitOf(const std::string& id) const {
  const auto found = std::ranges::find(m_found, id, &Quantity::id);
  return found == m_found.end() ? std::nullopt : std::optional(found->unit);
}

void FoundQuantities::moveTo(std::vector<QuantityHistory>& quantities, double coverage) {
  for (Quantity& quantity : m_found)
    quantities.push_back({quantity.id, quantity.unit, historyOf(std::move(quantity.values), 0, coverage)});
}

void setBaseline(std::vector<QuantityHistory>& quantities, std::size_t baseline,
                 const std::vector<double>& days) {
  baseline = std::min(baseline, days.size());
  const double last = baseline > 0 ? days[baseline - 1] : 0;
  for (QuantityHistory& quantity : quantities) {
    const std::vector<DatedValue>& values = quantity.history.values;
    const auto until =
        std::ranges::count_if(values, [&](const DatedValue& value) { return value.day <= last; });
    setBaseline(quantity.history,
                baseline == 0 || values.size() == days.size() ? baseline : static_cast<std::size_t>(until));
  }
}

}  // namespace alidade
