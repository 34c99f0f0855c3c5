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

constexpr double rounding = 1e-12;  // error of squared lengths, in variances of a reading

/// Returns a hash of a component (splitmix64); the sum of the hashes identifies a set.
std::uint64_t keyOf(std::size_t component) {
  std::uint64_t key = (component + 1) * 0x9e3779b97f4a7c15U;
  key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9U;
  key = (key ^ (key >> 27)) * 0x94d049bb133111ebU;
  return key ^ (key >> 31);
}

/// Keeps the `count` growths with the largest gain.
template <typename Growths>
void keepBest(Growths& growths, std::size_t count) {
  count = std::min(count, growths.size());
  std::ranges::partial_sort(growths, growths.begin() + static_cast<std::ptrdiff_t>(count), std::greater{},
                            [](const auto& growth) { return growth.gain.log; });
  growths.resize(count);
}

/// Returns an upper bound of the gain from each direction, for any width w. `squares` are squared lengths,
/// `products` squared products with the remaining leftover. With x = w² square/v and score = product/(square
/// v), the gain is −½ ln(1 + x) + ½ score x/(1 + x), which is largest at x = score − 1.
ArrayXd mostGain(const ArrayXd& squares, const ArrayXd& products, double narrowest, double variance) {
  const ArrayXd left = squares.max(rounding), scores = products / (left * variance),
                x = (scores - 1).max(narrowest * narrowest / variance * left);
  return 0.5 * (scores * x / (1 + x) - (1 + x).log());
}

}  // namespace

Search::Search(const Leftover& leftover, const Candidates& candidates, const SearchOptions& options)
    : m_leftover(leftover),
      m_candidates(candidates),
      m_options(options),
      m_table(leftover, candidates),
      m_right(m_table.products(leftover.residual())) {
  if (!candidates.haveGrossErrors()) return;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (candidates[i].onlyRow()) m_notSought.push_back(i);
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
    const ColumnProducts own =
        productsGiven(state, m_table.first(components[i]), m_table.count(components[i]));
    const Gain gain = gainFor(components[i], own.some(0, own.right.size()));
    const double logPosteriorOdds =
        state.found.logPosteriorOdds + gain.log + m_candidates.groupOf(components[i]).logPrior;
    const bool isLast = i + 1 == components.size();
    state = with(state, {.component = components[i], .gain = gain, .logPosteriorOdds = logPosteriorOdds},
                 !isLast);
  }
  return state.found;
}

Search::State Search::nothing() const {
  State nothing;
  nothing.found.chiSquare = m_leftover.chiSquare();
  return nothing;
}

Search::ColumnProducts Search::productsGiven(const State& state, Index first, Index count) const {
  if (state.found.logPosteriorOdds == impossible) return {VectorXd::Zero(count), MatrixXd(count, 0)};
  ColumnProducts given{m_right.segment(first, count), MatrixXd::Zero(count, state.taken.cols())};
  Index row = 0;
  for (const Part& part : state.found.parts) {
    const auto products = m_products.at(part.component).middleRows(first, count);
    given.right -= products.lazyProduct(state.off.segment(row, products.cols()));
    given.shared += products.lazyProduct(state.taken.middleRows(row, products.cols()));
    row += products.cols();
  }
  return given;
}

std::vector<Search::State> Search::next(const std::vector<State>& level) {
  std::vector<Growth> growths;
  for (std::size_t i = 0; i < level.size() && !isStopped(); ++i) offer(level[i], i, growths);
  // A set may result from several growths: the growth from the best state counts.
  std::vector<std::size_t> order(growths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, std::greater{}, [&](std::size_t i) { return growths[i].logPosteriorOdds; });
  // Sets with a pattern never grow, so they are limited separately.
  std::vector<State> states;
  std::size_t shaped = 0;
  for (const std::size_t i : order) {
    if (isStopped()) break;
    const bool isShape = m_candidates[growths[i].component].isShape();
    if ((isShape ? shaped : states.size() - shaped) == m_options.beam) continue;
    const auto upToHere = std::span(growths).first(i);
    if (std::ranges::find(upToHere, growths[i].key, &Growth::key) != upToHere.end()) continue;
    State state = with(level[growths[i].state], growths[i]);
    if (state.found.logPosteriorOdds == impossible) continue;
    states.push_back(std::move(state));
    shaped += isShape ? 1 : 0;
  }
  return states;
}

/// A set whose last part lowers the evidence is kept, but never grows.
bool Search::mayGrow(const State& state) const {
  const auto parts = state.found.parts.size();
  if (state.found.shaped || state.found.parts.back().logGain < 0) return false;
  if (parts < m_options.mostParts) return true;
  return state.grossErrors == static_cast<int>(parts) && parts < m_options.mostGrossErrors;
}

Search::State Search::makeImpossible(State state) const {
  Part& last = state.found.parts.back();
  last.weights.setZero();
  state.found.logPosteriorOdds = state.found.logBayesFactor = last.logGain = impossible;
  state.found.chiSquare = m_leftover.chiSquare();
  return state;
}

/// Adds the most promising components to `growths`.
void Search::offer(const State& state, std::size_t index, std::vector<Growth>& growths) const {
  const auto add = [&](const Candidates::Group& group, Growth growth) {
    if (growth.gain.log == impossible || state.found.has(growth.component)) return;
    growth.state = index;
    growth.logPosteriorOdds = state.found.logPosteriorOdds + growth.gain.log + group.logPrior;
    growth.key = state.key + keyOf(growth.component);
    growths.push_back(growth);
  };
  const ColumnProducts all = productsGiven(state, 0, m_table.size());
  const auto isTheOne = [&](const Part& part) { return m_candidates.groupOf(part.component).oneAtMost; };
  const bool hasOne = std::ranges::any_of(state.found.parts, isTheOne);
  for (const Candidates::Group& group : m_candidates.groups()) {
    if (group.offered > 0) continue;
    for (std::size_t i = group.first; i < group.first + group.count; ++i)
      if (!state.found.has(i))
        add(group, {.component = i, .gain = gainFor(i, all.some(m_table.first(i), m_table.count(i)))});
  }
  for (const Candidates::Group& group : m_candidates.groups()) {
    if (group.offered == 0 || (group.oneAtMost && hasOne)) continue;
    for (const Growth& growth : bestOf(group, all)) add(group, growth);
  }
}

std::vector<Search::Growth> Search::bestOf(const Candidates::Group& group, const ColumnProducts& all) const {
  ArrayXd most = m_table.count(group.first) == 1 ? mostOfSingles(group, all) : mostOfPairs(group, all);
  for (const std::size_t component : m_notSought)
    if (group.has(component)) most[static_cast<Index>(component - group.first)] = impossible;
  std::vector<Index> order(group.count);
  std::iota(order.begin(), order.end(), Index{0});
  std::erase_if(order, [&](Index i) { return !std::isfinite(most[i]); });
  const auto promising = order.begin() + static_cast<std::ptrdiff_t>(std::min(group.offered, order.size()));
  std::ranges::partial_sort(order, promising, std::greater{}, [&](Index i) { return most[i]; });
  std::vector<Growth> best;
  for (const Index i : order) {
    if (best.size() == group.offered && most[i] <= best.back().gain.log) continue;
    const std::size_t component = group.first + static_cast<std::size_t>(i);
    const auto own = all.some(m_table.first(component), m_table.count(component));
    best.push_back({.component = component, .gain = gainFor(component, own)});
    if (best.size() >= group.offered) keepBest(best, group.offered);
  }
  return best;
}

ArrayXd Search::mostOfSingles(const Candidates::Group& group, const ColumnProducts& all) const {
  constexpr double determined = 1e-6;  // squared length below which a column is numerically zero
  const Index first = m_table.first(group.first), count = static_cast<Index>(group.count);
  ArrayXd left = m_table.squares().segment(first, count);
  for (Index taken = 0; taken < all.shared.cols(); ++taken)
    left -= all.shared.col(taken).segment(first, count).array().square();
  const ArrayXd most = mostGain(left, all.right.segment(first, count).array().square(),
                                m_candidates[group.first].widths().front().sigma, m_variance);
  return (left < determined).select(impossible, most);
}

/// Upper bound: each of the two directions of a pair of columns has its optimal width.
ArrayXd Search::mostOfPairs(const Candidates::Group& group, const ColumnProducts& all) const {
  assert(m_table.count(group.first) == 2);
  const Index first = m_table.first(group.first), count = static_cast<Index>(group.count);
  const auto ofPairs = [&](const auto& vector, Index number) {
    return Eigen::Map<const ArrayXd, 0, Eigen::InnerStride<2>>(vector.data() + first + number, count);
  };
  // The Gram matrix of both columns, and their products with the remaining leftover.
  ArrayXd one = ofPairs(m_table.squares(), 0), other = ofPairs(m_table.squares(), 1),
          both = ofPairs(m_table.subdiagonal(), 0);
  for (Index taken = 0; taken < all.shared.cols(); ++taken) {
    const auto ofOne = ofPairs(all.shared.col(taken), 0), ofOther = ofPairs(all.shared.col(taken), 1);
    one -= ofOne.square();
    other -= ofOther.square();
    both -= ofOne * ofOther;
  }
  const auto rightOne = ofPairs(all.right, 0), rightOther = ofPairs(all.right, 1);
  const ArrayXd middle = (one + other) / 2, half = (one - other) / 2,
                apart = (half.square() + both.square()).sqrt(),
                right = rightOne.square() + rightOther.square(),
                turned = half * (rightOne.square() - rightOther.square()) + 2 * both * rightOne * rightOther,
                along = (right + (turned / apart.max(rounding)).max(-right).min(right)) / 2;
  const double narrowest = m_candidates[group.first].widths().front().sigma;
  return mostGain(middle + apart, along, narrowest, m_variance) +
         mostGain(middle - apart, right - along, narrowest, m_variance);
}

TurnedColumns Search::turnedColumns(std::size_t component, const ColumnProductsView& own) const {
  const Index first = m_table.first(component), count = m_table.count(component);
  return {m_table.squares().segment(first, count), m_table.subdiagonal().segment(first, count - 1), own.right,
          own.shared};
}

Gain Search::gainFor(std::size_t component, const ColumnProductsView& own) const {
  return m_candidates[component].gain(turnedColumns(component, own), m_variance);
}

Search::State Search::with(const State& state, const Growth& growth, bool inAnyCase) {
  const std::size_t component = growth.component;
  const Index count = m_table.count(component);
  State next;
  next.found = state.found;
  next.found.logPosteriorOdds = growth.logPosteriorOdds;
  next.found.logBayesFactor += growth.gain.log;
  next.found.parts.push_back({component, growth.gain.width, VectorXd::Ones(1), growth.gain.log});
  next.found.shaped = m_candidates[component].isShape();
  next.grossErrors = state.grossErrors + (m_candidates[component].grossErrorAt() ? 1 : 0);
  next.key = growth.key;

  if (state.found.logPosteriorOdds == impossible) return makeImpossible(std::move(next));

  const auto [right, before] = productsGiven(state, m_table.first(component), count);
  const MatrixXd gram = m_table.gram(component) - before * before.transpose();
  const LinearPart linear =
      m_candidates[component].linearPart(turnedColumns(component, {right, before}), m_variance);
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
    return makeImpossible(std::move(next));  // only rounding errors remain of the columns
  next.found.chiSquare = std::max(next.found.chiSquare, 0.0);
  if (!inAnyCase && !mayGrow(next)) return next;

  if (!m_products.contains(component)) m_products[component] = m_table.productsOf(component);
  // P times these factors gives products with all columns (`State`): `own` for the component's columns
  // without their part in the eliminated directions, `added` for the directions that the component adds.
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

}  // namespace alidade
