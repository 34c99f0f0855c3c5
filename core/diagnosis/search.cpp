#include "core/diagnosis/search.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <span>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr std::size_t jumpsOffered = 2, misreadingsOffered = 4;

/// A number that tells sets apart when added up (splitmix64).
std::uint64_t keyOf(std::size_t component) {
  std::uint64_t key = (component + 1) * 0x9e3779b97f4a7c15U;
  key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9U;
  key = (key ^ (key >> 27)) * 0x94d049bb133111ebU;
  return key ^ (key >> 31);
}

/// The `count` with the greatest gain.
template <typename Growths>
void keepBest(Growths& growths, std::size_t count) {
  count = std::min(count, growths.size());
  std::ranges::partial_sort(growths, growths.begin() + static_cast<std::ptrdiff_t>(count), std::greater{},
                            [](const auto& growth) { return growth.gain.log; });
  growths.resize(count);
}

}  // namespace

Search::Search(const Leftover& leftover, const std::vector<Component>& candidates,
               const SearchOptions& options)
    : m_leftover(leftover), m_candidates(candidates), m_options(options), m_table(leftover, candidates) {}

std::vector<Explanation> Search::grown(double variance) {
  m_variance = variance;
  std::vector<State> level{nothing()};
  std::vector<Explanation> found{level.front().found};
  while (!level.empty() && !isStopped()) {
    level = next(level);
    for (const State& state : level) found.push_back(state.found);
    std::erase_if(level, [&](const State& s) { return !mayGrow(s); });
  }
  return found;
}

Explanation Search::madeOf(const std::vector<std::size_t>& components, double variance) {
  m_variance = variance;
  State state = nothing();
  for (std::size_t i = 0; i < components.size(); ++i) {
    const Gain gain = gainFor(state, components[i]);
    const double logOdds = state.found.logOdds + gain.log + priorOf(components[i]);
    const bool isLast = i + 1 == components.size();
    state = with(state, {.component = components[i], .gain = gain, .logOdds = logOdds}, !isLast);
  }
  return state.found;
}

Search::State Search::nothing() const {
  State nothing;
  nothing.found.chiSquare = m_leftover.chiSquare();
  nothing.right = m_table.products(m_leftover.residual());
  nothing.shared.resize(m_table.size(), 0);
  return nothing;
}

std::vector<Search::State> Search::next(const std::vector<State>& level) {
  std::vector<Growth> growths;
  for (std::size_t i = 0; i < level.size() && !isStopped(); ++i) offer(level[i], i, growths);
  // The same set may grow in several ways; the one from the best state counts.
  std::vector<std::size_t> order(growths.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, std::greater{}, [&](std::size_t i) { return growths[i].logOdds; });
  // Patterns never grow, so they take no place from what may.
  std::vector<State> states;
  std::size_t shaped = 0;
  for (const std::size_t i : order) {
    if (isStopped()) break;
    const bool isShape = isPattern(growths[i].component);
    if ((isShape ? shaped : states.size() - shaped) == m_options.beam) continue;
    const auto upToHere = std::span(growths).first(i);
    if (std::ranges::find(upToHere, growths[i].key, &Growth::key) != upToHere.end()) continue;
    states.push_back(with(level[growths[i].state], growths[i]));
    shaped += isShape ? 1 : 0;
  }
  return states;
}

bool Search::isPattern(std::size_t component) const {
  return component < m_candidates.size() && m_candidates[component].kind == Component::Kind::Shape;
}

/// A step that costs more than it gains is kept once, never grown further.
bool Search::mayGrow(const State& state) const {
  const auto parts = state.found.parts.size();
  if (state.found.shaped || state.found.parts.back().logGain < 0) return false;
  if (parts < m_options.mostParts) return true;
  return state.misreadings == static_cast<int>(parts) && parts < m_options.mostMisreadings;
}

double Search::priorOf(std::size_t component) const {
  if (component < m_candidates.size()) return m_candidates[component].logPrior;
  return std::log(m_options.odds.misreading / static_cast<double>(std::max<Index>(m_leftover.readings(), 1)));
}

/// The most promising components to add: of jumps and of misreadings the best few.
void Search::offer(const State& state, std::size_t index, std::vector<Growth>& growths) const {
  const bool hasJump = std::ranges::any_of(state.found.parts, [&](const Part& part) {
    return part.component < m_candidates.size() && m_candidates[part.component].kind == Component::Kind::Jump;
  });
  std::vector<Growth> offered, jumps;
  offered.reserve(m_candidates.size());
  jumps.reserve(m_candidates.size());
  for (std::size_t i = 0; i < m_candidates.size(); ++i) {
    const bool isJump = m_candidates[i].kind == Component::Kind::Jump;
    if (state.found.has(i) || (isJump && (hasJump || (m_options.misreadings && m_candidates[i].onlyRow))))
      continue;
    (isJump ? jumps : offered).push_back({.component = i, .gain = gainFor(state, i)});
  }
  keepBest(jumps, jumpsOffered);
  offered.insert(offered.end(), jumps.begin(), jumps.end());
  if (m_options.misreadings)
    for (const Growth& growth : misreadingsFor(state))
      if (!state.found.has(growth.component)) offered.push_back(growth);
  for (Growth& growth : offered) {
    growth.state = index;
    growth.logOdds = state.found.logOdds + growth.gain.log + priorOf(growth.component);
    growth.key = state.key + keyOf(growth.component);
    growths.push_back(growth);
  }
}

/// The best few: those with the highest scores, and whatever else could do better.
std::vector<Search::Growth> Search::misreadingsFor(const State& state) const {
  constexpr double determined = 1e-6;  // redundancy below which a reading can be anything
  const double narrowest = widthsOf(Component::Kind::Misreading).front().sigma;
  const Index readings = m_leftover.readings();
  Eigen::ArrayXd left = m_table.squares().tail(readings);
  for (Index taken = 0; taken < state.shared.cols(); ++taken)
    left -= state.shared.col(taken).tail(readings).array().square();
  const Eigen::ArrayXd scores =
      state.right.tail(readings).array().square() / (left.max(determined) * m_variance);
  // No width gains more: x = w² left/variance gains −½ ln(1 + x) + ½ score x/(1 + x), most at score − 1.
  const Eigen::ArrayXd x = (scores - 1).max(narrowest * narrowest / m_variance * left),
                       mostGains = 0.5 * (scores * x / (1 + x) - (1 + x).log());
  std::vector<Index> free;
  free.reserve(static_cast<std::size_t>(readings));
  for (Index i = 0; i < readings; ++i)
    if (left[i] >= determined) free.push_back(i);
  const std::size_t count = std::min(misreadingsOffered, free.size());
  std::ranges::partial_sort(free, free.begin() + static_cast<std::ptrdiff_t>(count), std::greater{},
                            [&](Index i) { return scores[i]; });
  std::vector<Growth> best;
  for (const Index i : free)
    if (best.size() < misreadingsOffered || mostGains[i] > best.back().gain.log) {
      const std::size_t component = m_candidates.size() + static_cast<std::size_t>(i);
      best.push_back({.component = component, .gain = gainFor(state, component)});
      if (best.size() >= misreadingsOffered) keepBest(best, misreadingsOffered);
    }
  keepBest(best, misreadingsOffered);
  return best;
}

Gain Search::gainFor(const State& state, std::size_t component) const {
  constexpr double shows = 10;  // natural logarithm
  const Index first = m_table.first(component), count = m_table.count(component);
  auto kind = Component::Kind::Misreading;
  if (component < m_candidates.size()) {
    const Component& candidate = m_candidates[component];
    kind = candidate.kind;
    if (candidate.allOrNothing) {
      const double square = m_table.squares()[first] - state.shared.row(first).squaredNorm();
      return {(state.right[first] - square / 2) / m_variance, 1};
    }
    if (candidate.curvature.cols() > 0) return bentFor(state, component).gain;
  }
  const TurnedColumns columns{m_table.squares().segment(first, count),
                              m_table.beside().segment(first, count - 1), state.right.segment(first, count),
                              state.shared.middleRows(first, count)};
  const Gain gain = gainOf(widthsOf(kind), columns, m_variance);
  // Knocks of any size show at the usual widths, too, and most moments show none.
  const bool isKnock = kind == Component::Kind::Jump && gain.log > shows;
  return isKnock ? gainOf(widthsOfKnocks(), columns, m_variance) : gain;
}

BentFit Search::bentFor(const State& state, std::size_t component) const {
  const Index first = m_table.first(component), count = m_table.count(component);
  const auto shared = state.shared.middleRows(first, count);
  return fitBent(widthsOf(Component::Kind::Effect), m_table.gram(component) - shared * shared.transpose(),
                 state.right.segment(first, count), m_variance);
}

const MatrixXd& Search::productsOf(std::size_t component) {
  const auto [entry, isNew] = m_products.try_emplace(component);
  if (isNew) entry->second = m_table.productsOf(component);
  return entry->second;
}

Search::State Search::with(const State& state, const Growth& growth, bool inAnyCase) {
  const std::size_t component = growth.component;
  const Index first = m_table.first(component), count = m_table.count(component);
  State next;
  next.found = state.found;
  next.found.logOdds = growth.logOdds;
  next.found.logEvidence += growth.gain.log;
  next.found.parts.push_back({component, growth.gain.width, VectorXd::Ones(1), growth.gain.log});
  next.found.shaped = isPattern(component);
  next.misreadings = state.misreadings + (component < m_candidates.size() ? 0 : 1);
  next.key = growth.key;

  const MatrixXd before = state.shared.middleRows(first, count);
  const MatrixXd gram = m_table.gram(component) - before * before.transpose();
  const VectorXd right = state.right.segment(first, count);
  const Linear linear = linearFor(state, component);
  const VectorXd left = linear.isPlain ? right : linear.slope.transpose() * (right - gram * linear.fixed);
  MatrixXd matrix = linear.isPlain ? gram : linear.slope.transpose() * gram * linear.slope;
  matrix.diagonal().array() += m_variance / (growth.gain.width * growth.gain.width);
  const Eigen::LLT<MatrixXd> factor(matrix);
  const VectorXd along = factor.matrixL().solve(left);
  next.found.chiSquare -= along.squaredNorm();
  if (!linear.isPlain) next.found.chiSquare += linear.fixed.dot(gram * linear.fixed - 2 * right);
  if (along.size() > 0)
    next.found.parts.back().weights = m_table.weights(component, factor.matrixU().solve(along));
  if (!inAnyCase && !mayGrow(next)) return next;

  const MatrixXd products = productsOf(component) - state.shared * before.transpose();
  MatrixXd taken = MatrixXd::Identity(matrix.rows(), matrix.cols());
  factor.matrixU().solveInPlace(taken);
  if (!linear.isPlain) taken = linear.slope * taken;
  const MatrixXd added = products.lazyProduct(taken);  // too few columns for blocking
  next.shared.resize(m_table.size(), state.shared.cols() + added.cols());
  next.shared << state.shared, added;
  next.right = state.right - added * along;
  if (!linear.isPlain) next.right -= products * linear.fixed;
  return next;
}

Search::Linear Search::linearFor(const State& state, std::size_t component) const {
  if (component < m_candidates.size() && m_candidates[component].allOrNothing)
    return {false, VectorXd::Ones(1), MatrixXd(1, 0)};
  if (component < m_candidates.size() && m_candidates[component].curvature.cols() > 0) {
    const VectorXd at = bentFor(state, component).weights;
    const auto slope = bentDerivatives(at);
    return {false, bentWeights(at) - slope * at, slope};
  }
  return {};
}

}  // namespace alidade
