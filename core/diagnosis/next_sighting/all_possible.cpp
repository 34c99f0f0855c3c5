#include "core/diagnosis/next_sighting/all_possible.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/observability/look_alikes.h"
#include "core/diagnosis/result/thresholds.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// The columns of the unknowns and of the effects, side by side.
MatrixXd withEffects(const SightingRows& rows, Index effectColumns) {
  MatrixXd all(rows.unknowns.rows(), rows.unknowns.cols() + effectColumns);
  all << rows.unknowns, rows.causes.leftCols(effectColumns);
  return all;
}

/// Gram matrix of all columns of effects in all sightings, taken and possible, with the unknowns eliminated.
MatrixXd gramOfAll(const SightingEquations& equations) {
  const Index effects = equations.effectColumns;
  MatrixXd normal = equations.priorWeights.cwiseAbs2().asDiagonal();
  MatrixXd mixed = MatrixXd::Zero(normal.rows(), effects), gram = MatrixXd::Zero(effects, effects);
  const auto add = [&](const SightingRows& rows) {
    const auto own = rows.causes.leftCols(effects);
    normal += rows.unknowns.transpose() * rows.unknowns;
    mixed += rows.unknowns.transpose() * own;
    gram += own.transpose() * own;
  };
  add(equations.taken);
  for (const SightingRows& rows : equations.possible) add(rows);
  const MatrixXd gone = normal.llt().matrixL().solve(mixed);
  return gram - gone.transpose() * gone;
}

/// Whether a trace of squared length `square` is closer than `thresholds.hardlyDifferent` σ to one of
/// `effect`. `gram` has the inner products of all columns of effects, `trace` those with the trace.
bool isHardlyDifferent(const Hypothesis& effect, const MatrixXd& gram, const VectorXd& trace, double square) {
  constexpr double invisible = 1e-6;
  MatrixXd own = gram.block(effect.first, effect.first, effect.count, effect.count);
  own.diagonal().array() += invisible;
  const VectorXd right = trace.segment(effect.first, effect.count);
  if (effect.isBent) return differenceFromBent(own, right, square) < thresholds.hardlyDifferent;
  const double left =
      effect.widths ? square - right.dot(own.ldlt().solve(right)) : square - 2 * right[0] + own(0, 0);
  return left < thresholds.hardlyDifferent * thresholds.hardlyDifferent;
}

}  // namespace

IntersectionSoFar::IntersectionSoFar(const SightingEquations& equations)
    : m_effectColumns(equations.effectColumns) {
  constexpr double held = 1e6;  // weight that leaves a column at 0
  VectorXd weights = VectorXd::Ones(m_effectColumns);
  for (const Hypothesis& hypothesis : equations.hypotheses) {
    const Index sized = !hypothesis.widths ? 0 : hypothesis.isBent ? 2 : hypothesis.count;
    if (hypothesis.first < m_effectColumns)
      weights.segment(hypothesis.first + sized, hypothesis.count - sized).setConstant(held);
  }
  SightingEquations every{.taken = {withEffects(equations.taken, m_effectColumns), {}},
                          .residual = equations.residual,
                          .possible = {},
                          .priorWeights = equations.priorWeights,
                          .priorResiduals = equations.priorResiduals,
                          .intersection = equations.intersection,
                          .hypotheses = {}};
  every.appendPriors(weights);
  const NormalEquations normal = normalEquationsOf(every);
  m_normal.compute(normal.matrix);
  m_gain = m_normal.solve(every.intersection);
  m_value = equations.intersectionAt + m_gain.dot(normal.right);
  m_variance = m_gain.dot(every.intersection);
}

double IntersectionSoFar::sigmaKnowing(const Hypothesis& effect) const {
  const Index size = m_gain.size(), first = size - m_effectColumns + effect.first;
  const MatrixXd covariance = m_normal.solve(MatrixXd::Identity(size, size).middleCols(first, effect.count))
                                  .middleRows(first, effect.count);
  const VectorXd own = m_gain.segment(first, effect.count);
  return std::sqrt(std::max(m_variance - own.dot(covariance.ldlt().solve(own)), 0.0));
}

double IntersectionSoFar::logReductionBy(const SightingRows& rows) const {
  const MatrixXd all = withEffects(rows, m_effectColumns);
  const MatrixXd half = m_normal.matrixL().solve(all.transpose());
  MatrixXd covariance = half.transpose() * half;
  covariance.diagonal().array() += 1;
  const VectorXd shift = covariance.llt().matrixL().solve(all * m_gain);
  return -std::log1p(-std::min(shift.squaredNorm() / m_variance, 1 - 1e-12)) / 2;
}

std::vector<std::string> inseparableFrom(const Weighed& cause, const SightingEquations& equations) {
  std::vector<std::string> group{std::string(cause.cause)};
  const Index count = cause.weights.size();
  if (cause.first >= equations.effectColumns || count == 0) return group;
  const MatrixXd gram = gramOfAll(equations);
  const VectorXd trace = gram.middleCols(cause.first, count) * cause.weights;
  const double square = cause.weights.dot(trace.segment(cause.first, count));
  for (const Hypothesis& other : equations.hypotheses) {
    if (other.first == cause.first || other.first >= equations.effectColumns || other.priorOdds == 0)
      continue;
    if (isHardlyDifferent(other, gram, trace, square)) group.emplace_back(other.cause);
  }
  return group;
}

}  // namespace alidade
