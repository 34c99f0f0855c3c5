#pragma once

#include <cstddef>
#include <vector>

namespace alidade {

/// Sums Σ w, Σ w x and Σ w x² over the values of one date or of consecutive dates.
struct WeightedSums {
  double w = 0, wx = 0, wxx = 0;

  double mean() const { return wx / w; }
  double chiSquare() const;  ///< about the mean, ≥ 0
  WeightedSums& operator+=(const WeightedSums& other);
};

/// The sums of each date, in order. Sums over consecutive dates take constant time.
class DateSums {
 public:
  explicit DateSums(const std::vector<WeightedSums>& dates);

  std::size_t count() const { return m_upTo.size() - 1; }
  WeightedSums between(std::size_t first, std::size_t end) const;

 private:
  std::vector<WeightedSums> m_upTo;
};

/// The steps that minimise χ² for their number, with a separate level before, between and after the steps.
struct Stepping {
  std::vector<std::size_t> firsts;  ///< index of the first date after each step, ascending
  double chiSquare = 0;
};

/// Exact search by dynamic programming over the dates (Bellman 1961; Auger and Lawrence 1989), with one step
/// more per call. Time grows with the square of the number of dates.
class StepSearch {
 public:
  explicit StepSearch(const DateSums& dates);

  /// The n-th call returns the best dates of n steps. Needs more dates than steps.
  Stepping next();

 private:
  const DateSums& m_dates;
  std::vector<double> m_best;                      ///< [end]: least χ² of the dates before `end`
  std::vector<std::vector<std::size_t>> m_behind;  ///< [steps − 1][end]: first date after the last step
};

}  // namespace alidade
