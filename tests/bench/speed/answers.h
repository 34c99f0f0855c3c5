#pragma once

#include <benchmark/benchmark.h>

#include "core/observation/guideway.h"

namespace alidade::bench {

/// Records the circle with the time, for `table.py` to compare between programs.
inline void answer(benchmark::State& state, const Circle& circle) {
  state.counters["x"] = circle.x;
  state.counters["y"] = circle.y;
  state.counters["R"] = circle.radius;
}

/// The mean circle of many arcs, as their one result for the comparison.
class MeanCircle {
 public:
  void add(const Circle& circle) {
    m_sum.x += circle.x;
    m_sum.y += circle.y;
    m_sum.radius += circle.radius;
    ++m_count;
  }

  Circle value() const { return {m_sum.x / m_count, m_sum.y / m_count, m_sum.radius / m_count}; }

 private:
  Circle m_sum;
  int m_count = 0;
};

}  // namespace alidade::bench
