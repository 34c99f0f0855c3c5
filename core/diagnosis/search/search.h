#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/diagnosis/search/column_table.h"
#include "core/diagnosis/search/explanation.h"

namespace alidade {

/// Grows sets of components by one component at a time with constant noise variance, and keeps the best few
/// of each size. It uses inner products of columns only: an eliminated column is represented by its products
/// with every column.
class Search {
 public:
  Search(const Leftover& leftover, const Candidates& candidates, const SearchOptions& options);

  /// `variance` is the variance of the readings in units of the stated variance. `logPosteriorOdds` and
  /// `logBayesFactor` are relative to the empty set with the same noise. The first result is the empty set.
  std::vector<Explanation> grown(double variance);
  /// Returns the set of exactly these components, which are added in this order.
  Explanation madeOf(const std::vector<std::size_t>& components, double variance);

 private:
  /// A set of components, eliminated from the leftover. P is the matrix of the products of all columns with
  /// the columns of these components.
  struct State {
    Explanation found;
    /// The products of all columns with the remaining leftover equal their products with the leftover, minus
    /// P `off`. Empty, like `taken`, if the set does not grow.
    Eigen::VectorXd off;
    /// P `taken` are the products of the eliminated directions with all columns: one column for each
    /// direction.
    Eigen::MatrixXd taken;
    int grossErrors = 0;
    std::uint64_t key = 0;  ///< hash of the set, independent of the order
  };
  /// Products of some columns with the remaining leftover and the eliminated directions of a state.
  struct ColumnProductsView {
    Eigen::Ref<const Eigen::VectorXd> right;   ///< their products with the remaining leftover
    Eigen::Ref<const Eigen::MatrixXd> shared;  ///< their products with the eliminated directions,
                                               ///< which reduce their Gram matrix by shared sharedᵀ
  };
  struct ColumnProducts {
    Eigen::VectorXd right;
    Eigen::MatrixXd shared;
    ColumnProductsView some(Eigen::Index first, Eigen::Index count) const {
      // A matrix without columns has no valid data pointer.
      if (shared.cols() == 0)
        return {right.segment(first, count), Eigen::Map<const Eigen::MatrixXd>(nullptr, count, 0)};
      return {right.segment(first, count), shared.middleRows(first, count)};
    }
  };
  /// A possible growth of a state by one component.
  struct Growth {
    std::size_t state = 0, component = 0;
    Gain gain;
    double logPosteriorOdds = 0;
    std::uint64_t key = 0;
  };

  const Leftover& m_leftover;
  const Candidates& m_candidates;
  const SearchOptions& m_options;
  ColumnTable m_table;
  std::vector<std::size_t> m_notSought;               ///< jumps that leave the trace of a gross error
  Eigen::VectorXd m_right;                            ///< products of all columns with the leftover
  std::map<std::size_t, Eigen::MatrixXd> m_products;  ///< products of all columns with the components of sets
  double m_variance = 1;

  std::vector<State> next(const std::vector<State>& level);
  void offer(const State& state, std::size_t index, std::vector<Growth>& growths) const;
  ColumnProducts productsGiven(const State& state, Eigen::Index first, Eigen::Index count) const;
  /// Returns the growths with the largest gain by one component of a group.
  std::vector<Growth> bestOf(const Candidates::Group& group, const ColumnProducts& all) const;
  /// Upper bounds of the gain of each component in a group of one-column or two-column components.
  Eigen::ArrayXd mostOfSingles(const Candidates::Group& group, const ColumnProducts& all) const;
  Eigen::ArrayXd mostOfPairs(const Candidates::Group& group, const ColumnProducts& all) const;
  TurnedColumns turnedColumns(std::size_t component, const ColumnProductsView& own) const;
  /// Gain of a component from the products of its columns.
  Gain gainFor(std::size_t component, const ColumnProductsView& own) const;
  State nothing() const;
  /// With `inAnyCase` the new state can grow even if `mayGrow` returns false.
  State with(const State& state, const Growth& growth, bool inAnyCase = false);
  /// Marks a state whose last component can be neither evaluated nor eliminated.
  State makeImpossible(State state) const;
  bool isStopped() const { return m_options.stop.stop_requested(); }
  bool mayGrow(const State& state) const;
};

}  // namespace alidade
