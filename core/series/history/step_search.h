#pragma once

#include <cstddef>
#include <vector>

namespace alidade {

/// Values of one date, or a stretch of dates, summed with their weights w.
struct WeightedSums {
  double w = 0, wx = 0, wxx = 0;

  double mean() const { return wx / w; }
  double chiSquare() const;  ///< about their mean, ≥ 0
  WeightedSums& operator+=(const WeightedSums& other);
};

/// Dates in their order, each with its values. Sums over stretches of them take no time.
class DateSums {
 public:
  explicit DateSums(const std::vector<WeightedSums>& dates);

  std::size_t count() const { return m_upTo.size() - 1; }
  WeightedSums between(std::size_t first, std::size_t end) const;

 private:
  std::vector<WeightedSums> m_upTo;
};

/// The stretches with a level each that leave the least χ², for a given number of steps.
struct Stepping {
  std::vector<std::size_t> firsts;  ///< of each step the index of the first date after it, rising
  double chiSquare = 0;
};

/// Exact, for one step more with each call, by dynamic programming over the dates (Bellman 1961; Auger and
/// Lawrence 1989): time grows with the square of their number.
class StepSearch {
 public:
  explicit StepSearch(const DateSums& dates);

  /// With one step more than before; the first call has one. There must be a date for it.
  Stepping next();

 private:
  const DateSums& m_dates;
  std::vector<double> m_best;                      ///< least χ² of the dates before `end`
  std::vector<std::vector<std::size_t>> m_behind;  ///< for each number of steps: where the last one is
};

}  // namespace alidade
