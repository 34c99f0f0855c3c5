#include "core/diagnosis/explanation.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double impossible = -std::numeric_limits<double>::infinity();

double logSum(double a, double b) {
  if (a < b) std::swap(a, b);
  return std::isinf(b) ? a : a + std::log1p(std::exp(b - a));
}

/// A set of components, eliminated from the leftover at one scale of the noise.
struct State {
  Explanation found;
  double variance = 1;  ///< of the readings, in units of the stated one
  VectorXd observed;    ///< the leftover less what does not depend on weights
  VectorXd residual;    ///< what is left of it, columns taken off at their weights
  MatrixXd taken;       ///< V with leftover metric P − V Vᵀ
  bool shaped = false;
  int misreadings = 0;
};

/// What one more component would add.
struct Gain {
  double log = impossible;
  double width = 1;
};

/// Over the widths of the component, from the eigenvalues λ of its visible Gram matrix and the components c
/// of its right side: ln ∫ = Σ −½ ln(1 + w²λ/v) + ½ (w c/v)²/(1 + w²λ/v).
Gain gainOver(const std::vector<Width>& widths, const VectorXd& lambda, const VectorXd& c, double variance) {
  Gain gain;
  double best = impossible;
  for (const Width& width : widths) {
    double log = width.logChance;
    const double w2 = width.sigma * width.sigma / variance;
    for (Index i = 0; i < lambda.size(); ++i) {
      const double grown = 1 + w2 * std::max(lambda[i], 0.0);
      log += -0.5 * std::log(grown) + 0.5 * w2 * c[i] * c[i] / variance / grown;
    }
    gain.log = logSum(gain.log, log);
    if (log > best) {
      best = log;
      gain.width = width.sigma;
    }
  }
  return gain;
}

Gain gainOf(const std::vector<Width>& widths, const MatrixXd& gram, const VectorXd& right, double variance) {
  if (gram.rows() == 1) return gainOver(widths, gram.col(0), right, variance);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram);
  return gainOver(widths, eigen.eigenvalues(), eigen.eigenvectors().transpose() * right, variance);
}

/// The weights of a bending component: on a grid over what is plausible, then closing in on the best.
struct BentFit {
  Gain gain;
  VectorXd weights;
};

/// `gram` and `right` of its two columns and three second derivatives. Widths too narrow for the grid are
/// taken as if it did not bend.
BentFit fitBent(const std::vector<Width>& widths, const MatrixXd& gram, const VectorXd& right,
                double variance) {
  constexpr double reach = 9, step = 0.4, narrow = 0.5;
  const auto log = [&](double x, double y) {
    VectorXd z(5);
    z << x, y, x * x / 2, x * y, y * y / 2;
    return (right.dot(z) - 0.5 * z.dot(gram * z)) / variance;
  };
  std::vector<Width> linear, bent;
  for (const Width& width : widths) (width.sigma < narrow ? linear : bent).push_back(width);
  BentFit fit{gainOf(linear, gram.topLeftCorner(2, 2), right.head(2), variance), VectorXd::Zero(2)};
  double best = fit.gain.log;
  std::vector<double> sums(bent.size(), impossible);
  for (double x = -reach; x <= reach; x += step)
    for (double y = -reach; y <= reach; y += step) {
      const double value = log(x, y), squared = x * x + y * y;
      for (std::size_t w = 0; w < bent.size(); ++w) {
        const double variance2 = bent[w].sigma * bent[w].sigma;
        const double density = value - squared / (2 * variance2) - std::log(2 * M_PI * variance2);
        sums[w] = logSum(sums[w], density + 2 * std::log(step) + bent[w].logChance);
        if (density > best) {
          best = density;
          fit.gain.width = bent[w].sigma;
          fit.weights << x, y;
        }
      }
    }
  for (const double sum : sums) fit.gain.log = logSum(fit.gain.log, sum);
  for (double size = step / 2; size > 1e-4; size /= 2) {
    const VectorXd centre = fit.weights;
    double highest = impossible;
    for (const double dx : {-size, 0.0, size})
      for (const double dy : {-size, 0.0, size}) {
        const VectorXd at = centre + Eigen::Vector2d(dx, dy);
        const double value = log(at[0], at[1]) - at.squaredNorm() / (2 * fit.gain.width * fit.gain.width);
        if (value > highest) {
          highest = value;
          fit.weights = at;
        }
      }
  }
  return fit;
}

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

  std::size_t misreadingOf(Index reading) const {
    return m_candidates.size() + static_cast<std::size_t>(reading);
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
    if (state.shaped) return false;
    if (parts < m_options.mostParts) return true;
    return state.misreadings == static_cast<int>(parts) && parts < m_options.mostMisreadings;
  }

  double misreadingPrior() const {
    return std::log(m_options.odds.misreading /
                    static_cast<double>(std::max<Index>(m_leftover.readings(), 1)));
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
      const Gain gain = gainOver(widthsOf(Component::Kind::Misreading), VectorXd::Constant(1, left),
                                 VectorXd::Constant(1, state.residual[i]), state.variance);
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
    next.shaped = !isReading && m_candidates[component].kind == Component::Kind::Shape;
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

/// ln ∫ p(scale) (evidence at the scale/evidence at `reference`) over ln scale in [from, to], with
/// `logDensity` of ln scale: −f ln scale − ½ χ²/scale².
template <typename Density>
double logOverScales(double chiSquare, double f, double reference, double from, double to,
                     const Density& logDensity, double& likeliest) {
  constexpr int steps = 60;
  const double step = (to - from) / steps;
  double sum = impossible, best = impossible;
  for (int i = 0; i <= steps; ++i) {
    const double log = from + step * i, scale = std::exp(log);
    const double value = logDensity(log) - f * (log - std::log(reference)) -
                         0.5 * chiSquare * (1 / (scale * scale) - 1 / (reference * reference));
    sum = logSum(sum, value);
    if (value > best) {
      best = value;
      likeliest = scale;
    }
  }
  return sum + std::log(step);
}

constexpr double knownTo = 0.1;  // the stated σ holds to a tenth
constexpr double leastNoise = 1.25, mostNoise = 20;

void weighNominal(Explanation& found, double f) {
  const auto density = [](double log) {
    return -0.5 * std::pow(log / knownTo, 2) - std::log(knownTo) - 0.5 * std::log(2 * M_PI);
  };
  found.logEvidence += logOverScales(found.chiSquare, f, 1, -4 * knownTo, 4 * knownTo, density, found.noise);
}

void weighNoisy(Explanation& found, double f, double reference, double leftover) {
  const double from = std::log(leastNoise), to = std::log(mostNoise);
  const auto density = [&](double) { return -std::log(to - from); };
  found.noisy = true;
  found.logEvidence += logOverScales(found.chiSquare, f, reference, from, to, density, found.noise);
  found.logEvidence += -f * std::log(reference) - 0.5 * leftover * (1 / (reference * reference) - 1);
}

}  // namespace

std::vector<Explanation> explain(const Leftover& leftover, const std::vector<Component>& candidates,
                                 const SearchOptions& options) {
  const Search search(leftover, candidates, options);
  const double f = leftover.degreesOfFreedom(), chiSquare = leftover.chiSquare();
  std::vector<State> nominal;
  search.grow(search.nothing(1), nominal);
  std::vector<Explanation> all;
  double least = chiSquare;
  double bestOdds = impossible;
  for (State& state : nominal) {
    const double prior = state.found.logOdds - state.found.logEvidence;
    weighNominal(state.found, f);
    state.found.logOdds = prior + state.found.logEvidence;
    if (state.found.logOdds > bestOdds && !state.shaped) {
      bestOdds = state.found.logOdds;
      least = state.found.chiSquare;
    }
    all.push_back(state.found);
  }
  std::vector<double> references;
  for (const double left : {chiSquare, least}) {
    const double reference = std::clamp(std::sqrt(left / std::max(f, 1.0)), leastNoise, mostNoise);
    if (references.empty() || reference < 0.8 * references.back()) references.push_back(reference);
  }
  if (!options.noise) references.clear();
  for (const double reference : references) {
    std::vector<State> noisy;
    search.grow(search.nothing(reference * reference), noisy);
    for (State& state : noisy) {
      const double prior = state.found.logOdds - state.found.logEvidence + std::log(options.odds.noise);
      weighNoisy(state.found, f, reference, chiSquare);
      state.found.logOdds = prior + state.found.logEvidence;
      all.push_back(state.found);
    }
  }
  const double base = all.front().logEvidence;  // nothing at all, noise as stated
  for (Explanation& explanation : all) {
    explanation.logOdds -= base;
    explanation.logEvidence -= base;
  }
  std::ranges::sort(all, std::greater{}, &Explanation::logOdds);
  return all;
}

VectorXd signature(const Component& component, const VectorXd& weights) {
  VectorXd result = component.columns * weights;
  if (component.curvature.cols() == 0) return result;
  const Eigen::Vector3d second(weights[0] * weights[0] / 2, weights[0] * weights[1],
                               weights[1] * weights[1] / 2);
  return result + component.curvature * second;
}

double logBayesFactor(const Leftover& leftover, const Component& component) {
  if (component.allOrNothing)
    return component.columns.col(0).dot(leftover.residual()) - component.columns.squaredNorm() / 2;
  if (component.curvature.cols() > 0) {
    MatrixXd columns(component.columns.rows(), 5);
    columns << component.columns, component.curvature;
    return fitBent(widthsOf(component.kind), columns.transpose() * columns,
                   columns.transpose() * leftover.residual(), 1)
        .gain.log;
  }
  return gainOf(widthsOf(component.kind), component.columns.transpose() * component.columns,
                component.columns.transpose() * leftover.residual(), 1)
      .log;
}

}  // namespace alidade
