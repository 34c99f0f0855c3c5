#include "core/series/shared_causes/shared_search.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Widths of the prior, in plausible sizes: a series can show far smaller sizes than one session.
constexpr double widths[] = {0.03, 0.1, 0.3, 1, 3};

std::span<const double> spanOf(const RowMajor& matrix) {
  return {matrix.data(), static_cast<std::size_t>(matrix.size())};
}
std::span<const double> spanOf(const VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}

/// For each session that both blocks contain, calls `visit` with its index in `a` and in `b`.
template <typename Visit>
void forCommon(const EffectBlock& a, const EffectBlock& b, const Visit& visit) {
  std::size_t i = 0, j = 0;
  while (i < a.sessions.size() && j < b.sessions.size()) {
    if (a.sessions[i] == b.sessions[j])
      visit(i++, j++);
    else
      a.sessions[i] < b.sessions[j] ? ++i : ++j;
  }
}

bool overlap(const EffectBlock& a, const EffectBlock& b) {
  bool any = false;
  forCommon(a, b, [&](std::size_t, std::size_t) { any = true; });
  return any;
}

double logSumOf(const std::vector<double>& logs) {
  const double most = *std::ranges::max_element(logs);
  double sum = 0;
  for (const double log : logs) sum += std::exp(log - most);
  return most + std::log(sum);
}

/// Probabilities from the logarithms of odds. The odds are scaled by the largest to avoid overflow.
std::vector<double> chancesByLog(std::vector<double> logs) {
  const double most = *std::ranges::max_element(logs);
  double sum = 0;
  for (double& log : logs) sum += log = std::exp(log - most);
  for (double& chance : logs) chance /= sum;
  return logs;
}

/// Calls `add` with j, l and aⱼ bₗ for each pair of features that are not zero.
template <typename Add>
void addProducts(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b, const Add& add) {
  for (Index j = 0; j < a.size(); ++j)
    for (Index l = 0; l < b.size(); ++l)
      if (a[j] != 0 && b[l] != 0) add(j, l, a[j] * b[l]);
}

}  // namespace

EffectVector SharedPart::weightsIn(std::size_t index) const {
  const auto count = static_cast<Index>(block.columns().count);
  const Eigen::RowVectorXd features = block.featuresOf(index);
  EffectVector own = EffectVector::Zero(count);
  for (Index j = 0; j < features.size(); ++j) own += features[j] * weights.segment(j * count, count);
  return own;
}

/// The normal equations of a block after eliminating a set, and the products of the block with the set's z.
struct SharedSearch::GivenSet {
  MatrixXd products, gram;
  VectorXd right;
};

SharedSearch::Sums SharedSearch::sumsOf(const EffectBlock& block,
                                        const std::vector<std::size_t>& explanations,
                                        const Counts& counts) const {
  const auto count = static_cast<Index>(block.columns().count), size = count * block.rank();
  Sums sums{MatrixXd::Zero(size, size), VectorXd::Zero(size)};
  for (std::size_t i = 0; i < block.sessions.size(); ++i) {
    const std::size_t s = block.sessions[i];
    if (counts && !counts(s)) continue;
    const EffectMatrix normal = m_sessions[s].normal(explanations[s], block.columns(), block.columns());
    const EffectVector right = m_sessions[s].right(explanations[s], block.columns());
    const Eigen::RowVectorXd features = block.featuresOf(i);
    addProducts(features, features, [&](Index j, Index l, double product) {
      sums.normal.block(j * count, l * count, count, count) += product * normal;
    });
    for (Index j = 0; j < features.size(); ++j) sums.right.segment(j * count, count) += features[j] * right;
  }
  return sums;
}

MatrixXd SharedSearch::across(const EffectBlock& a, const EffectBlock& b,
                              const std::vector<std::size_t>& explanations, const Counts& counts) const {
  const auto ofA = static_cast<Index>(a.columns().count), ofB = static_cast<Index>(b.columns().count);
  MatrixXd sum = MatrixXd::Zero(ofA * a.rank(), ofB * b.rank());
  forCommon(a, b, [&](std::size_t i, std::size_t j) {
    const std::size_t s = a.sessions[i];
    if (counts && !counts(s)) return;
    const EffectMatrix normal = m_sessions[s].normal(explanations[s], a.columns(), b.columns());
    addProducts(a.featuresOf(i), b.featuresOf(j), [&](Index k, Index l, double product) {
      sum.block(k * ofA, l * ofB, ofA, ofB) += product * normal;
    });
  });
  return sum;
}

SharedSearch::GivenSet SharedSearch::given(const SharedSet& set, const MatrixXd& posterior,
                                           const EffectBlock& block,
                                           const std::vector<std::size_t>& explanations,
                                           const Counts& counts) const {
  Sums sums = sumsOf(block, explanations, counts);
  GivenSet result{MatrixXd::Zero(sums.right.size(), posterior.cols()), std::move(sums.normal),
                  std::move(sums.right)};
  Index first = 0;
  for (const SharedPart& part : set.parts) {
    const MatrixXd products = across(block, part.block, explanations, counts);
    result.right -= products * part.weights;
    result.products.middleCols(first, part.slope.cols()) = products * part.slope;
    first += part.slope.cols();
  }
  result.gram -= result.products * posterior * result.products.transpose();
  return result;
}

/// Extends the set's posterior by the block's weights (block matrix inversion).
void SharedSearch::take(SharedSet& set, const EffectBlock& block, const Counts& counts) const {
  const Response response = block.columns().effect->response;
  const GivenSet own = given(set, set.covariance, block, set.explanations, counts);
  const RowMajor gram = own.gram;
  const ColumnGain gain = columnGain(response, spanOf(gram), spanOf(own.right), widths);
  SharedPart part{
      .block = block, .width = gain.width, .logGain = gain.log, .fixed = {}, .slope = {}, .weights = {}};
  const Index size = own.right.size();
  part.fixed = VectorXd::Zero(size);
  if (response == Response::AllOrNothing) {
    part.fixed[0] = 1;
    part.slope = MatrixXd(size, 0);
  } else if (response == Response::Bent) {
    const double x = gain.weights[0], y = gain.weights[1];
    part.slope = MatrixXd::Zero(size, 2);
    part.slope << 1, 0, 0, 1, x, 0, y, x, 0, y;
    part.fixed << 0, 0, -x * x / 2, -x * y, -y * y / 2;
  } else {
    part.slope = MatrixXd::Identity(size, size);
  }
  const Index before = set.covariance.cols(), added = part.slope.cols();
  MatrixXd matrix = part.slope.transpose() * own.gram * part.slope;
  matrix.diagonal().array() += 1 / (part.width * part.width);
  const MatrixXd inverse = matrix.ldlt().solve(MatrixXd::Identity(added, added));
  const VectorXd z = inverse * (part.slope.transpose() * (own.right - own.gram * part.fixed));
  part.weights = part.fixed + part.slope * z;
  const MatrixXd along = set.covariance * own.products.transpose();
  const VectorXd moved = along * part.weights;
  Index first = 0;
  for (SharedPart& earlier : set.parts) {
    earlier.weights -= earlier.slope * moved.segment(first, earlier.slope.cols());
    first += earlier.slope.cols();
  }
  MatrixXd covariance(before + added, before + added);
  const MatrixXd lower = -along * part.slope * inverse;
  covariance.topLeftCorner(before, before) = set.covariance - lower * (along * part.slope).transpose();
  covariance.topRightCorner(before, added) = lower;
  covariance.bottomLeftCorner(added, before) = lower.transpose();
  covariance.bottomRightCorner(added, added) = inverse;
  set.covariance = std::move(covariance);
  set.parts.push_back(std::move(part));
}

SharedSet SharedSearch::fitted(const std::vector<EffectBlock>& blocks,
                               const std::vector<std::size_t>& explanations, const Counts& counts) const {
  SharedSet set;
  set.explanations = explanations;
  set.covariance = MatrixXd(0, 0);
  for (const EffectBlock& block : blocks) {
    take(set, block, counts);
    set.logPosteriorOdds += set.parts.back().logGain + block.logPrior;
  }
  return set;
}

double SharedSearch::oddsOfExplanations(const SharedSet& set) const {
  double sum = 0;
  for (std::size_t s = 0; s < m_sessions.size(); ++s) {
    const std::vector<double> odds = explanationOdds(s, set);
    // The sizes were fitted with the chosen explanation; the sum includes the alternatives.
    const std::size_t chosen = set.explanations[s];
    sum += ownOdds(s, chosen) + logSumOf(odds) - odds[chosen];
  }
  return sum;
}

/// Log of prior odds × evidence of an explanation, without any shared effect. The odds of an explanation with
/// causes are divided by the number of sessions.
double SharedSearch::ownOdds(std::size_t session, std::size_t explanation) const {
  const double each = -std::log(static_cast<double>(m_sessions.size()));
  return m_sessions[session].logOdds(explanation) + (explanation > 0 ? each : 0);
}

std::vector<double> SharedSearch::explanationOdds(std::size_t session, const SharedSet& set) const {
  const SessionSums& own = m_sessions[session];
  struct Share {
    const EffectColumns* columns;
    EffectVector weights;
  };
  std::vector<Share> shares;
  for (const SharedPart& part : set.parts) {
    const auto& sessions = part.block.sessions;
    const auto found = std::ranges::lower_bound(sessions, session);
    if (found == sessions.end() || *found != session) continue;
    shares.push_back(
        {&part.block.columns(), part.weightsIn(static_cast<std::size_t>(found - sessions.begin()))});
  }
  std::vector<double> odds(own.explanations());
  for (std::size_t k = 0; k < odds.size(); ++k) {
    odds[k] = ownOdds(session, k);
    for (const Share& a : shares) {
      odds[k] += own.right(k, *a.columns).dot(a.weights);
      for (const Share& b : shares)
        odds[k] -= 0.5 * a.weights.dot(own.normal(k, *a.columns, *b.columns).lazyProduct(b.weights));
    }
  }
  return odds;
}

std::vector<double> SharedSearch::explanationChances(std::size_t session, const SharedSet& set) const {
  return chancesByLog(explanationOdds(session, set));
}

std::vector<std::size_t> SharedSearch::likeliestExplanations(const SharedSet& set, bool withPatterns) const {
  std::vector<std::size_t> explanations(m_sessions.size(), 0);
  for (std::size_t s = 0; s < explanations.size(); ++s) {
    const std::vector<double> odds = explanationOdds(s, set);
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < odds.size(); ++k) {
      if ((!withPatterns && m_sessions[s].explanation(k).holdsPattern) || odds[k] <= most) continue;
      most = odds[k];
      explanations[s] = k;
    }
  }
  return explanations;
}

SharedSet SharedSearch::madeOf(const std::vector<EffectBlock>& blocks,
                               const std::vector<std::size_t>& explanations) const {
  constexpr int mostRounds = 4;
  constexpr double rounding = 1e-9;
  SharedSet best;
  std::vector<std::size_t> own = explanations;
  for (int round = 0; round < mostRounds; ++round) {
    SharedSet set = fitted(blocks, own);
    set.logPosteriorOdds += oddsOfExplanations(set);
    std::vector<std::size_t> next = likeliestExplanations(set, true);
    // At equal odds the later set counts: its explanations are the likeliest according to the earlier set.
    if (round == 0 || set.logPosteriorOdds > best.logPosteriorOdds - rounding) best = std::move(set);
    if (next == own || m_stop.stop_requested()) break;
    own = std::move(next);
  }
  return best;
}

bool SharedSearch::mayTake(const SharedSet& set, const EffectBlock& block) const {
  if (block.isPattern() && set.isShaped()) return false;
  return std::ranges::none_of(set.parts, [&](const SharedPart& part) {
    return part.block.effect == block.effect && overlap(part.block, block);
  });
}

/// Returns the effects, and separately the patterns, with the largest gain in addition to the set. They are
/// sought with misread values and noise as the only own causes, and again with the set's explanations. The
/// reason is that an effect visible in each session may also be an explanation of each session.
std::vector<SharedSearch::Growth> SharedSearch::promising(const SharedSet& set) const {
  constexpr std::size_t most = 6, mostPatterns = 3;
  std::vector<Growth> all;
  const auto offer = [&](const std::vector<std::size_t>& explanations) {
    std::vector<EffectBlock> blocks;
    for (const SharedPart& part : set.parts) blocks.push_back(part.block);
    const SharedSet from = fitted(blocks, explanations);
    std::vector<Growth> effects, patterns;
    for (std::size_t i = 0; i < m_blocks.size() && !m_stop.stop_requested(); ++i) {
      if (!mayTake(set, m_blocks[i])) continue;
      const GivenSet own = given(from, from.covariance, m_blocks[i], explanations, {});
      const RowMajor gram = own.gram;
      const ColumnGain gain =
          columnGain(m_blocks[i].columns().effect->response, spanOf(gram), spanOf(own.right), widths);
      if (std::isfinite(gain.log))
        (m_blocks[i].isPattern() ? patterns : effects).push_back({i, gain.log + m_blocks[i].logPrior});
    }
    const auto keep = [&](std::vector<Growth>& growths, std::size_t count) {
      const std::size_t kept = std::min(count, growths.size());
      std::ranges::partial_sort(growths, growths.begin() + static_cast<std::ptrdiff_t>(kept), std::greater{},
                                &Growth::log);
      for (std::size_t i = 0; i < kept; ++i)
        if (std::ranges::find(all, growths[i].block, &Growth::block) == all.end()) all.push_back(growths[i]);
    };
    keep(effects, most);
    keep(patterns, mostPatterns);
  };
  const std::vector<std::size_t> plain = likeliestExplanations(set, false);
  offer(plain);
  if (plain != set.explanations) offer(set.explanations);
  return all;
}

std::vector<SharedSet> SharedSearch::grown() const {
  constexpr std::size_t beam = 3, mostParts = 6;
  std::vector<SharedSet> found{madeOf({}, std::vector<std::size_t>(m_sessions.size(), 0))};
  std::vector<SharedSet> level{found.front()};
  const auto isFound = [&](const std::vector<EffectBlock>& blocks) {
    return std::ranges::any_of(found, [&](const SharedSet& set) {
      return set.parts.size() == blocks.size() && std::ranges::all_of(blocks, [&](const EffectBlock& block) {
               return std::ranges::any_of(set.parts, [&](const SharedPart& part) {
                 return part.block.isSame(block) && part.block.sessions == block.sessions;
               });
             });
    });
  };
  while (!level.empty() && !m_stop.stop_requested()) {
    std::vector<SharedSet> next;
    for (const SharedSet& set : level) {
      if (set.parts.size() == mostParts) continue;
      const std::vector<std::size_t> plain = likeliestExplanations(set, false);
      for (const Growth& growth : promising(set)) {
        std::vector<EffectBlock> blocks;
        for (const SharedPart& part : set.parts) blocks.push_back(part.block);
        blocks.push_back(m_blocks[growth.block]);
        if (isFound(blocks)) continue;
        SharedSet made = madeOf(blocks, plain);
        if (plain != set.explanations) {
          SharedSet other = madeOf(blocks, set.explanations);
          if (other.logPosteriorOdds > made.logPosteriorOdds) made = std::move(other);
        }
        if (!std::isfinite(made.logPosteriorOdds)) continue;
        found.push_back(made);
        const bool mayGrow = made.logPosteriorOdds > set.logPosteriorOdds && !made.isShaped();
        if (mayGrow) next.push_back(std::move(made));
      }
    }
    std::ranges::sort(next, std::greater{}, &SharedSet::logPosteriorOdds);
    if (next.size() > beam) next.resize(beam);
    level = std::move(next);
  }
  normalise(found);
  return found;
}

void normalise(std::vector<SharedSet>& sets) {
  std::vector<double> logs;
  for (const SharedSet& set : sets) logs.push_back(set.logPosteriorOdds);
  const std::vector<double> chances = chancesByLog(std::move(logs));
  for (std::size_t i = 0; i < sets.size(); ++i) sets[i].chance = chances[i];
  std::ranges::sort(sets, std::greater{}, &SharedSet::logPosteriorOdds);
}

ColumnGain SharedSearch::alone(const EffectBlock& block) const {
  const Sums sums = sumsOf(block, std::vector<std::size_t>(m_sessions.size(), 0), {});
  const RowMajor gram = sums.normal;
  return columnGain(block.columns().effect->response, spanOf(gram), spanOf(sums.right), widths);
}

double SharedSearch::visibleLengthIn(const SharedPart& part, std::size_t index) const {
  const VectorXd weights = part.weightsIn(index);
  const EffectColumns& columns = part.block.columns();
  const MatrixXd normal = m_sessions[part.block.sessions[index]].plainNormal(columns, columns);
  return std::sqrt(std::max(weights.dot(normal * weights), 0.0));
}

double SharedSearch::visibleLength(const SharedPart& part) const {
  double square = 0;
  for (std::size_t i = 0; i < part.block.sessions.size(); ++i)
    square += std::pow(visibleLengthIn(part, i), 2);
  return std::sqrt(square);
}

double SharedSearch::differenceFrom(const SharedPart& part, const EffectBlock& block) const {
  const std::vector<std::size_t> none(m_sessions.size(), 0);
  const Sums sums = sumsOf(block, none, {});
  const VectorXd right = across(block, part.block, none, {}) * part.weights;
  const double square = part.weights.dot(sumsOf(part.block, none, {}).normal * part.weights);
  const RowMajor gram = sums.normal;
  return leastDifference(block.columns().effect->response, spanOf(gram), spanOf(right), square);
}

}  // namespace alidade
