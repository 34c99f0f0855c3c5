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

/// Dates in order, each with its values. Sums over stretches of dates take constant time.
class DateSums {
 public:
  explicit DateSums(const std::vector<WeightedSums>& dates);

  std::size_t count() const { return m_upTo.size() - 1; }
  WeightedSums between(std::size_t first, std::size_t end) const;

 private:
  std::vector<WeightedSums> m_upTo;
};

/// The stretches, each with a level of its own, that minimise χ² for a given number of steps.
struct Stepping {
  std::vector<std::size_t> firsts;  ///< index of the first date after each step, ascending
  double chiSquare = 0;
};

/// Exact search by dynamic programming over the dates (Bellman 1961; Auger and Lawrence 1989), with one step
/// more per call. Time grows with the square of the number of dates.
class StepSearch {
 public:
  explicit StepSearch(const DateSums& dates);

  /// One step more than in the last call; one step in the first call. Requires more dates than steps.
  Stepping next();

 private:
  const DateSums& m_dates;
  std::vector<double> m_best;                      ///< [end]: least χ² of the dates before `end`
  std::vector<std::vector<std::size_t>> m_behind;  ///< [steps − 1][end]: first date after the last step
};

}  // namespace alidade
