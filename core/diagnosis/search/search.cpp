#include "core/diagnosis/search/search.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <span>

namespace alidade {

using Eigen::ArrayXd, Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr std::size_t jumpsOffered = 2, misreadingsOffered = 4;
constexpr double rounding = 1e-12;  // of squared lengths, in variances of a reading

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

/// What a direction gains at most, whatever its width: of columns with the squared lengths `squares`, and
/// their products with what is left, squared. x = w² square/v gains −½ ln(1 + x) + ½ score x/(1 + x), most at
/// x = score − 1.
ArrayXd mostGain(const ArrayXd& squares, const ArrayXd& products, Component::Kind kind, double variance) {
  const double narrowest = widthsOf(kind).front().sigma;
  const ArrayXd left = squares.max(rounding), scores = products / (left * variance),
                x = (scores - 1).max(narrowest * narrowest / variance * left);
  return 0.5 * (scores * x / (1 + x) - (1 + x).log());
}

}  // namespace

Search::Search(const Leftover& leftover, const std::vector<Component>& candidates,
               const SearchOptions& options)
    : m_leftover(leftover),
      m_candidates(candidates),
      m_options(options),
      m_table(leftover, candidates),
      m_right(m_table.products(leftover.residual())) {
  const auto isJump = [](const Component& candidate) { return candidate.kind == Component::Kind::Jump; };
  const auto first = std::ranges::find_if(candidates, isJump);
  const auto end = std::find_if_not(first, candidates.end(), isJump);
  assert(std::none_of(end, candidates.end(), isJump));
  m_firstJump = static_cast<std::size_t>(first - candidates.begin());
  m_jumps = static_cast<std::size_t>(end - first);
}

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
    const Beside own = beside(state, m_table.first(components[i]), m_table.count(components[i]));
    const Gain gain = gainFor(components[i], own.some(0, own.right.size()));
    const double logOdds = state.found.logOdds + gain.log + priorOf(components[i]);
    const bool isLast = i + 1 == components.size();
    state = with(state, {.component = components[i], .gain = gain, .logOdds = logOdds}, !isLast);
  }
  return state.found;
}

Search::State Search::nothing() const {
  State nothing;
  nothing.found.chiSquare = m_leftover.chiSquare();
  return nothing;
}

Search::Beside Search::beside(const State& state, Index first, Index count) const {
  if (state.found.logOdds == impossible) return {VectorXd::Zero(count), MatrixXd(count, 0)};
  Beside beside{m_right.segment(first, count), MatrixXd::Zero(count, state.taken.cols())};
  Index row = 0;
  for (const Part& part : state.found.parts) {
    const auto products = m_products.at(part.component).middleRows(first, count);
    beside.right -= products.lazyProduct(state.off.segment(row, products.cols()));
    beside.shared += products.lazyProduct(state.taken.middleRows(row, products.cols()));
    row += products.cols();
  }
  return beside;
}

std::vector<Search::State> Search::next(const std::vector<State>& level) {
  std::vector<Growth> growths;
  for (std::size_t i = 0; i < level.size() && !isStopped(); ++i) offer(level[i], i, growths);
  // The same set may grow in several ways; the one from the best state counts.
  std::vector<std::size_t> order(growths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, std::greater{}, [&](std::size_t i) { return growths[i].logOdds; });
  // Patterns never grow, so they take no place from what may.
  std::vector<State> states;
  std::size_t shaped = 0;
  for (const std::size_t i : order) {
    if (isStopped()) break;
    const bool isShape = kindOf(growths[i].component) == Component::Kind::Shape;
    if ((isShape ? shaped : states.size() - shaped) == m_options.beam) continue;
    const auto upToHere = std::span(growths).first(i);
    if (std::ranges::find(upToHere, growths[i].key, &Growth::key) != upToHere.end()) continue;
    State state = with(level[growths[i].state], growths[i]);
    if (state.found.logOdds == impossible) continue;
    states.push_back(std::move(state));
    shaped += isShape ? 1 : 0;
  }
  return states;
}

Component::Kind Search::kindOf(std::size_t component) const {
  return component < m_candidates.size() ? m_candidates[component].kind : Component::Kind::Misreading;
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

Search::State Search::makeImpossible(State state) const {
  Part& last = state.found.parts.back();
  last.weights.setZero();
  state.found.logOdds = state.found.logEvidence = last.logGain = impossible;
  state.found.chiSquare = m_leftover.chiSquare();
  return state;
}

/// The most promising components to add: of jumps and of misreadings the best few.
void Search::offer(const State& state, std::size_t index, std::vector<Growth>& growths) const {
  const auto add = [&](Growth growth) {
    if (growth.gain.log == impossible) return;
    growth.state = index;
    growth.logOdds = state.found.logOdds + growth.gain.log + priorOf(growth.component);
    growth.key = state.key + keyOf(growth.component);
    growths.push_back(growth);
  };
  const Beside all = beside(state, 0, m_table.size());
  for (std::size_t i = 0; i < m_candidates.size(); ++i)
    if (m_candidates[i].kind != Component::Kind::Jump && !state.found.has(i))
      add({.component = i, .gain = gainFor(i, all.some(m_table.first(i), m_table.count(i)))});
  const bool hasJump = std::ranges::any_of(
      state.found.parts, [&](const Part& part) { return kindOf(part.component) == Component::Kind::Jump; });
  if (!hasJump && m_jumps > 0) std::ranges::for_each(jumpsFor(all), add);
  if (m_options.misreadings)
    for (const Growth& growth : misreadingsFor(all))
      if (!state.found.has(growth.component)) add(growth);
}

std::vector<Search::Growth> Search::bestOf(const Beside& all, std::size_t first, const ArrayXd& most,
                                           std::size_t count) const {
  std::vector<Index> order(static_cast<std::size_t>(most.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::erase_if(order, [&](Index i) { return !std::isfinite(most[i]); });
  const auto promising = order.begin() + static_cast<std::ptrdiff_t>(std::min(count, order.size()));
  std::ranges::partial_sort(order, promising, std::greater{}, [&](Index i) { return most[i]; });
  std::vector<Growth> best;
  for (const Index i : order) {
    if (best.size() == count && most[i] <= best.back().gain.log) continue;
    const std::size_t component = first + static_cast<std::size_t>(i);
    const auto own = all.some(m_table.first(component), m_table.count(component));
    best.push_back({.component = component, .gain = gainFor(component, own)});
    if (best.size() >= count) keepBest(best, count);
  }
  return best;
}

/// As if the two directions in which a jump shows had each the width that suits it.
std::vector<Search::Growth> Search::jumpsFor(const Beside& all) const {
  const Index first = m_table.first(m_firstJump), count = static_cast<Index>(m_jumps);
  const auto ofJumps = [&](const auto& vector, Index number) {
    return Eigen::Map<const ArrayXd, 0, Eigen::InnerStride<2>>(vector.data() + first + number, count);
  };
  // The Gram matrix of the horizontal and the vertical column, and their products with what is left.
  ArrayXd h = ofJumps(m_table.squares(), 0), v = ofJumps(m_table.squares(), 1),
          both = ofJumps(m_table.beside(), 0);
  for (Index taken = 0; taken < all.shared.cols(); ++taken) {
    const auto ofH = ofJumps(all.shared.col(taken), 0), ofV = ofJumps(all.shared.col(taken), 1);
    h -= ofH.square();
    v -= ofV.square();
    both -= ofH * ofV;
  }
  const auto rightH = ofJumps(all.right, 0), rightV = ofJumps(all.right, 1);
  const ArrayXd middle = (h + v) / 2, half = (h - v) / 2, apart = (half.square() + both.square()).sqrt(),
                right = rightH.square() + rightV.square(),
                turned = half * (rightH.square() - rightV.square()) + 2 * both * rightH * rightV,
                along = (right + (turned / apart.max(rounding)).max(-right).min(right)) / 2;
  ArrayXd most = mostGain(middle + apart, along, Component::Kind::Jump, m_variance) +
                 mostGain(middle - apart, right - along, Component::Kind::Jump, m_variance);
  if (m_options.misreadings)
    for (Index i = 0; i < count; ++i)
      if (m_candidates[m_firstJump + static_cast<std::size_t>(i)].onlyRow) most[i] = impossible;
  return bestOf(all, m_firstJump, most, jumpsOffered);
}

std::vector<Search::Growth> Search::misreadingsFor(const Beside& all) const {
  constexpr double determined = 1e-6;  // redundancy below which a reading can be anything
  const Index readings = m_leftover.readings();
  ArrayXd left = m_table.squares().tail(readings);
  for (Index taken = 0; taken < all.shared.cols(); ++taken)
    left -= all.shared.col(taken).tail(readings).array().square();
  const ArrayXd most =
      mostGain(left, all.right.tail(readings).array().square(), Component::Kind::Misreading, m_variance);
  return bestOf(all, m_candidates.size(), (left < determined).select(impossible, most), misreadingsOffered);
}

Gain Search::gainFor(std::size_t component, const SomeBeside& own) const {
  constexpr double shows = 10;  // natural logarithm
  const Index first = m_table.first(component), count = m_table.count(component);
  const Component::Kind kind = kindOf(component);
  if (component < m_candidates.size()) {
    const Component& candidate = m_candidates[component];
    if (candidate.allOrNothing) {
      const double square = m_table.squares()[first] - own.shared.squaredNorm();
      return {(own.right[0] - square / 2) / m_variance, 1};
    }
    if (candidate.curvature.cols() > 0) return bentFor(component, own).gain;
  }
  const TurnedColumns columns{m_table.squares().segment(first, count),
                              m_table.beside().segment(first, count - 1), own.right, own.shared};
  const Gain gain = gainOf(widthsOf(kind), columns, m_variance);
  // Knocks of any size show at the usual widths, too, and most moments show none.
  const bool isKnock = kind == Component::Kind::Jump && gain.log > shows;
  return isKnock ? gainOf(widthsOfKnocks(), columns, m_variance) : gain;
}

BentFit Search::bentFor(std::size_t component, const SomeBeside& own) const {
  return fitBent(widthsOf(Component::Kind::Effect),
                 m_table.gram(component) - own.shared * own.shared.transpose(), own.right, m_variance);
}

Search::State Search::with(const State& state, const Growth& growth, bool inAnyCase) {
  const std::size_t component = growth.component;
  const Index count = m_table.count(component);
  State next;
  next.found = state.found;
  next.found.logOdds = growth.logOdds;
  next.found.logEvidence += growth.gain.log;
  next.found.parts.push_back({component, growth.gain.width, VectorXd::Ones(1), growth.gain.log});
  next.found.shaped = kindOf(component) == Component::Kind::Shape;
  next.misreadings = state.misreadings + (component < m_candidates.size() ? 0 : 1);
  next.key = growth.key;

  if (state.found.logOdds == impossible) return makeImpossible(std::move(next));

  const auto [right, before] = beside(state, m_table.first(component), count);
  const MatrixXd gram = m_table.gram(component) - before * before.transpose();
  const Linear linear = linearFor(component, {right, before});
  const VectorXd left = linear.isPlain ? right : linear.slope.transpose() * (right - gram * linear.fixed);
  MatrixXd matrix = linear.isPlain ? gram : linear.slope.transpose() * gram * linear.slope;
  matrix.diagonal().array() += m_variance / (growth.gain.width * growth.gain.width);
  const Eigen::LLT<MatrixXd> factor(matrix);
  const VectorXd along = factor.matrixL().solve(left);
  next.found.chiSquare -= along.squaredNorm();
  if (!linear.isPlain) next.found.chiSquare += linear.fixed.dot(gram * linear.fixed - 2 * right);
  if (along.size() > 0)
    next.found.parts.back().weights = m_table.weights(component, factor.matrixU().solve(along));
  if (!std::isfinite(next.found.chiSquare) || !next.found.parts.back().weights.allFinite())
    return makeImpossible(std::move(next));  // rounding has left nothing of the columns
  next.found.chiSquare = std::max(next.found.chiSquare, 0.0);
  if (!inAnyCase && !mayGrow(next)) return next;

  if (!m_products.contains(component)) m_products[component] = m_table.productsOf(component);
  // In terms of P: the component's columns beside what was taken before, and their directions.
  const Index parts = state.taken.rows(), directions = state.taken.cols();
  MatrixXd own(parts + count, count);
  own << -state.taken * before.transpose(), MatrixXd::Identity(count, count);
  MatrixXd taken = MatrixXd::Identity(matrix.rows(), matrix.cols());
  factor.matrixU().solveInPlace(taken);
  if (!linear.isPlain) taken = linear.slope * taken;
  const MatrixXd added = own * taken;
  next.taken.setZero(parts + count, directions + added.cols());
  next.taken.topLeftCorner(parts, directions) = state.taken;
  next.taken.rightCols(added.cols()) = added;
  next.off = added * along;
  next.off.head(parts) += state.off;
  if (!linear.isPlain) next.off += own * linear.fixed;
  return next;
}

Search::Linear Search::linearFor(std::size_t component, const SomeBeside& own) const {
  if (component < m_candidates.size() && m_candidates[component].allOrNothing)
    return {false, VectorXd::Ones(1), MatrixXd(1, 0)};
  if (component < m_candidates.size() && m_candidates[component].curvature.cols() > 0) {
    const VectorXd at = bentFor(component, own).weights;
    const auto slope = bentDerivatives(at);
    return {false, bentWeights(at) - slope * at, slope};
  }
  return {};
}

}  // namespace alidade
