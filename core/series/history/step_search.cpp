#include "core/series/history/step_search.h"

#include <algorithm>
#include <limits>

namespace alidade {

double WeightedSums::chiSquare() const {
  return w > 0 ? std::max(0.0, wxx - wx * wx / w) : 0;
}

WeightedSums& WeightedSums::operator+=(const WeightedSums& other) {
  w += other.w;
  wx += other.wx;
  wxx += other.wxx;
  return *this;
}

DateSums::DateSums(const std::vector<WeightedSums>& dates) : m_upTo(1) {
  m_upTo.reserve(dates.size() + 1);
  for (const WeightedSums& date : dates) {
    m_upTo.push_back(m_upTo.back());
    m_upTo.back() += date;
  }
}

WeightedSums DateSums::between(std::size_t first, std::size_t end) const {
  const WeightedSums &from = m_upTo[first], &to = m_upTo[end];
  return {to.w - from.w, to.wx - from.wx, to.wxx - from.wxx};
}

StepSearch::StepSearch(const DateSums& dates) : m_dates(dates) {
  for (std::size_t end = 0; end <= dates.count(); ++end) m_best.push_back(dates.between(0, end).chiSquare());
}

Stepping StepSearch::next() {
  const std::size_t count = m_dates.count(), steps = m_behind.size() + 1;
  std::vector<double> best(count + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> behind(count + 1, 0);
  for (std::size_t end = steps + 1; end <= count; ++end)
    for (std::size_t first = steps; first < end; ++first) {
      const double chiSquare = m_best[first] + m_dates.between(first, end).chiSquare();
      if (chiSquare < best[end]) {
        best[end] = chiSquare;
        behind[end] = first;
      }
    }
  m_best = std::move(best);
  m_behind.push_back(std::move(behind));
  Stepping stepping{std::vector<std::size_t>(steps), m_best[count]};
  for (std::size_t step = steps, end = count; step > 0; --step)
    end = stepping.firsts[step - 1] = m_behind[step - 1][end];
  return stepping;
}

}  // namespace alidade
