#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/diagnosis/search/column_table.h"
#include "core/diagnosis/search/explanation.h"

namespace alidade {

/// Sets of components, grown one component at a time with the noise held at some variance; the best few of
/// each size are kept. Works on the inner products of the columns alone: what is taken off is noted by its
/// products with every column.
class Search {
 public:
  Search(const Leftover& leftover, const Candidates& candidates, const SearchOptions& options);

  /// `variance`: of the readings, in units of the stated one. `logPosteriorOdds` and `logBayesFactor` are
  /// against nothing with the same noise. The first is the empty set.
  std::vector<Explanation> grown(double variance);
  /// Exactly these components, each as it is beside those before it.
  Explanation madeOf(const std::vector<std::size_t>& components, double variance);

 private:
  /// A set of components, taken off the leftover. Of every column it tells by its products with the columns
  /// of those components, P, which sets have in common.
  struct State {
    Explanation found;
    /// What is left: of its products with all columns, those of the leftover less P `off`. Empty, like
    /// `taken`, where the set does not grow.
    Eigen::VectorXd off;
    /// What was taken: its products with all columns are P `taken`. A column for each direction.
    Eigen::MatrixXd taken;
    int grossErrors = 0;
    std::uint64_t key = 0;  ///< of the set, whatever the order
  };
  /// Columns beside a state.
  struct SomeBeside {
    Eigen::Ref<const Eigen::VectorXd> right;   ///< their products with what is left
    Eigen::Ref<const Eigen::MatrixXd> shared;  ///< with what was taken; their Gram matrix is less its square
  };
  struct Beside {
    Eigen::VectorXd right;
    Eigen::MatrixXd shared;
    SomeBeside some(Eigen::Index first, Eigen::Index count) const {
      // A matrix without columns has no address to count rows from.
      if (shared.cols() == 0)
        return {right.segment(first, count), Eigen::Map<const Eigen::MatrixXd>(nullptr, count, 0)};
      return {right.segment(first, count), shared.middleRows(first, count)};
    }
  };
  /// A component that a state may take next.
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
  std::vector<std::size_t> m_notSought;               ///< since gross errors that leave the same are
  Eigen::VectorXd m_right;                            ///< products of all columns with the leftover
  std::map<std::size_t, Eigen::MatrixXd> m_products;  ///< of all columns with components that were taken
  double m_variance = 1;

  std::vector<State> next(const std::vector<State>& level);
  void offer(const State& state, std::size_t index, std::vector<Growth>& growths) const;
  Beside beside(const State& state, Eigen::Index first, Eigen::Index count) const;
  /// Those of a group that gain most.
  std::vector<Growth> bestOf(const Candidates::Group& group, const Beside& all) const;
  /// What each of a group gains at most, of one column each or of two.
  Eigen::ArrayXd mostOfSingles(const Candidates::Group& group, const Beside& all) const;
  Eigen::ArrayXd mostOfPairs(const Candidates::Group& group, const Beside& all) const;
  TurnedColumns turnedColumns(std::size_t component, const SomeBeside& own) const;
  /// Of a component with its columns.
  Gain gainFor(std::size_t component, const SomeBeside& own) const;
  State nothing() const;
  /// `inAnyCase`: ready for more even where the search would add none.
  State with(const State& state, const Growth& growth, bool inAnyCase = false);
  /// Its last component can be neither weighed nor taken off.
  State makeImpossible(State state) const;
  bool isStopped() const { return m_options.stop.stop_requested(); }
  bool mayGrow(const State& state) const;
};

}  // namespace alidade
