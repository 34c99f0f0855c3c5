#include "core/diagnosis/search.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <set>

#include "core/diagnosis/gain.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// A set of components, eliminated from the leftover at one scale of the noise.
struct State {
  Explanation found;
  double variance = 1;  ///< of the readings, in units of the stated one
  VectorXd observed;    ///< the leftover less what does not depend on weights
  VectorXd residual;    ///< what is left of it, columns taken off at their weights
  MatrixXd taken;       ///< V with leftover metric P − V Vᵀ
  int misreadings = 0;
};

class Search {
 public:
  Search(const Leftover& leftover, const std::vector<Component>& candidates, const SearchOptions& options)
      : m_leftover(leftover), m_candidates(candidates), m_options(options) {
    Index columns = 0;
    for (const Component& candidate : candidates) {
      m_first.push_back(columns);
      columns += candidate.columns.cols();
    }
    m_columns.resize(leftover.rows(), columns);
    for (std::size_t i = 0; i < candidates.size(); ++i)
      m_columns.middleCols(m_first[i], candidates[i].columns.cols()) = candidates[i].columns;
    m_redundancy.resize(leftover.readings());
    for (Index i = 0; i < leftover.readings(); ++i) m_redundancy[i] = leftover.redundancy(i);
  }

  State nothing(double variance) const {
    State state;
    state.variance = variance;
    state.observed = state.residual = m_leftover.residual();
    state.taken.resize(m_leftover.rows(), 0);
    state.found.chiSquare = m_leftover.chiSquare();
    return state;
  }

  /// Grows `start` step by step; every state met goes to `all`.
  void grow(State start, std::vector<State>& all) const {
    std::vector<State> level{std::move(start)};
    all.push_back(level.front());
    std::set<std::vector<std::size_t>> seen;
    while (!level.empty()) {
      std::vector<State> next;
      for (const State& state : level)
        for (auto& [component, gain] : best(state))
          if (seen.insert(idsWith(state, component)).second) next.push_back(with(state, component, gain));
      std::ranges::sort(next, std::greater{}, [](const State& s) { return s.found.logOdds; });
      if (next.size() > m_options.beam) next.resize(m_options.beam);
      // A step that costs more than it gains is kept once, never grown further.
      for (const State& state : next) all.push_back(state);
      std::erase_if(next, [&](const State& s) { return !mayGrow(s) || s.found.parts.back().logGain < 0; });
      level = std::move(next);
    }
  }

 private:
  const Leftover& m_leftover;
  const std::vector<Component>& m_candidates;
  const SearchOptions& m_options;
  std::vector<Index> m_first;
  MatrixXd m_columns;
  VectorXd m_redundancy;

  bool mayGrow(const State& state) const {
    const auto parts = state.found.parts.size();
    if (state.found.shaped) return false;
    if (parts < m_options.mostParts) return true;
    return state.misreadings == static_cast<int>(parts) && parts < m_options.mostMisreadings;
  }

  double misreadingPrior() const {
    return std::log(m_options.odds.misreading /
                    static_cast<double>(std::max<Index>(m_leftover.readings(), 1)));
  }

  std::size_t misreadingOf(Index reading) const {
    return m_candidates.size() + static_cast<std::size_t>(reading);
  }

  static std::vector<std::size_t> idsWith(const State& state, std::size_t component) {
    std::vector<std::size_t> ids{component};
    for (const Part& part : state.found.parts) ids.push_back(part.component);
    std::ranges::sort(ids);
    return ids;
  }

  /// The most promising components to add: (index, gain). Of jumps and of misreadings the best few each.
  std::vector<std::pair<std::size_t, Gain>> best(const State& state) const {
    const VectorXd right = m_columns.transpose() * state.residual;
    const MatrixXd shared = state.taken.transpose() * m_columns;
    std::vector<std::pair<std::size_t, Gain>> effects, jumps, misreadings;
    for (std::size_t i = 0; i < m_candidates.size(); ++i) {
      const Component& candidate = m_candidates[i];
      if (std::ranges::find(state.found.parts, i, &Part::component) != state.found.parts.end()) continue;
      const bool isJump = candidate.kind == Component::Kind::Jump;
      if (isJump && hasJump(state)) continue;
      const Index first = m_first[i], count = candidate.columns.cols();
      if (candidate.allOrNothing) {
        const double size = candidate.columns.squaredNorm() - shared.col(first).squaredNorm();
        effects.emplace_back(i, Gain{(right[first] - size / 2) / state.variance, 1});
        continue;
      }
      if (candidate.curvature.cols() > 0) {
        effects.emplace_back(i, fitBent(state, candidate).gain);
        continue;
      }
      const auto share = shared.middleCols(first, count);
      const MatrixXd gram = candidate.columns.transpose() * candidate.columns - share.transpose() * share;
      const Gain gain = gainOf(widthsOf(candidate.kind), gram, right.segment(first, count), state.variance);
      (isJump ? jumps : effects).emplace_back(i, gain);
    }
    for (Index i = 0; m_options.misreadings && i < m_leftover.readings(); ++i) {
      if (std::ranges::find(state.found.parts, misreadingOf(i), &Part::component) != state.found.parts.end())
        continue;
      const double left = m_redundancy[i] - state.taken.row(i).squaredNorm();
      if (left < 1e-6) continue;
      const Gain gain =
          gainOf(widthsOf(Component::Kind::Misreading), left, state.residual[i], state.variance);
      misreadings.emplace_back(misreadingOf(i), gain);
    }
    const auto keep = [](auto& list, std::size_t count) {
      std::ranges::sort(list, std::greater{}, [](const auto& entry) { return entry.second.log; });
      if (list.size() > count) list.resize(count);
    };
    keep(jumps, 2);
    keep(misreadings, 4);
    effects.insert(effects.end(), jumps.begin(), jumps.end());
    effects.insert(effects.end(), misreadings.begin(), misreadings.end());
    return effects;
  }

  static BentFit fitBent(const State& state, const Component& candidate) {
    MatrixXd columns(candidate.columns.rows(), 5);
    columns << candidate.columns, candidate.curvature;
    const MatrixXd shared = state.taken.transpose() * columns;
    return alidade::fitBent(widthsOf(candidate.kind),
                            columns.transpose() * columns - shared.transpose() * shared,
                            columns.transpose() * state.residual, state.variance);
  }

  bool hasJump(const State& state) const {
    return std::ranges::any_of(state.found.parts, [&](const Part& part) {
      return part.component < m_candidates.size() &&
             m_candidates[part.component].kind == Component::Kind::Jump;
    });
  }

  State with(const State& state, std::size_t component, const Gain& gain) const {
    State next = state;
    const bool isReading = component >= m_candidates.size();
    MatrixXd columns;
    if (isReading) {
      VectorXd unit = VectorXd::Zero(m_leftover.readings());
      unit[static_cast<Index>(component - m_candidates.size())] = 1;
      columns = m_leftover.visible(unit);
    } else {
      const Component& candidate = m_candidates[component];
      columns = candidate.columns;
      if (candidate.allOrNothing) return withWhole(std::move(next), component, gain);
      if (candidate.curvature.cols() > 0) {
        const VectorXd at = fitBent(state, candidate).weights;
        const auto& second = candidate.curvature;
        columns.col(0) += second.col(0) * at[0] + second.col(1) * at[1];
        columns.col(1) += second.col(1) * at[0] + second.col(2) * at[1];
        next.observed -= signature(candidate, at) - columns * at;
        next.residual = next.observed - state.taken * (state.taken.transpose() * next.observed);
      }
    }
    const MatrixXd free = columns - state.taken * (state.taken.transpose() * columns);
    MatrixXd matrix = columns.transpose() * free;
    matrix.diagonal().array() += state.variance / (gain.width * gain.width);
    const Eigen::LLT<MatrixXd> factor(matrix);
    const VectorXd weights = factor.solve(columns.transpose() * next.residual);
    const MatrixXd added = factor.matrixL().solve(free.transpose()).transpose();
    next.taken.conservativeResize(Eigen::NoChange, state.taken.cols() + added.cols());
    next.taken.rightCols(added.cols()) = added;
    next.residual -= added * (added.transpose() * next.observed);
    next.found.shaped = !isReading && m_candidates[component].kind == Component::Kind::Shape;
    next.misreadings += isReading ? 1 : 0;
    return noted(std::move(next), {component, gain.width, weights, gain.log});
  }

  /// With all of a component or nothing of it.
  State withWhole(State next, std::size_t component, const Gain& gain) const {
    next.observed -= m_candidates[component].columns.col(0);
    next.residual = next.observed - next.taken * (next.taken.transpose() * next.observed);
    return noted(std::move(next), {component, 1, VectorXd::Ones(1), gain.log});
  }

  State noted(State next, Part part) const {
    const bool isReading = part.component >= m_candidates.size();
    next.found.chiSquare = next.observed.dot(next.residual);
    next.found.logEvidence += part.logGain;
    next.found.logOdds +=
        part.logGain + (isReading ? misreadingPrior() : m_candidates[part.component].logPrior);
    next.found.parts.push_back(std::move(part));
    return next;
  }
};

}  // namespace

std::vector<Explanation> grownSets(const Leftover& leftover, const std::vector<Component>& candidates,
                                   const SearchOptions& options, double variance) {
  const Search search(leftover, candidates, options);
  std::vector<State> states;
  search.grow(search.nothing(variance), states);
  std::vector<Explanation> sets;
  sets.reserve(states.size());
  for (State& state : states) sets.push_back(std::move(state.found));
  return sets;
}

}  // namespace alidade
