#include "core/diagnosis/next_sighting/weighed.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "core/diagnosis/evidence/bent_fit.h"
#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/result/noise_policy.h"
#include "core/effects/cause_ids.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double noiseScales[] = {1.5, 2, 3, 4};

/// ln of the Bayes factor of a scale of the noise against the stated noise.
double logOfNoise(double scale, double chiSquare, int degreesOfFreedom) {
  return chiSquare / 2 * (1 - 1 / (scale * scale)) - degreesOfFreedom * std::log(scale);
}

/// Collects the hypotheses by cause, with the likeliest of each.
class ByCause {
 public:
  void add(Weighed weighed, double logOdds) {
    Sum& sum = m_sums[weighed.cause];
    if (logOdds > sum.most) {
      sum.most = logOdds;
      sum.likeliest = std::move(weighed);
    }
    sum.log = logSum(sum.log, logOdds);
  }

  std::vector<Weighed> all() {
    double whole = impossible;
    for (const auto& [cause, sum] : m_sums) whole = logSum(whole, sum.log);
    std::vector<Weighed> list;
    for (auto& [cause, sum] : m_sums) {
      sum.likeliest.probability = std::exp(sum.log - whole);
      sum.likeliest.logOdds = sum.log;
      list.push_back(std::move(sum.likeliest));
    }
    std::ranges::stable_sort(list, std::greater{}, &Weighed::logOdds);
    return list;
  }

 private:
  struct Sum {
    Weighed likeliest;
    double most = impossible, log = impossible;
  };
  std::map<std::string_view, Sum> m_sums;
};

}  // namespace

WeighedCauses::WeighedCauses(const SightingEquations& equations) : m_equations(equations) {
  const MatrixXd& unknowns = equations.taken.unknowns;
  const NormalEquations normal = normalEquationsOf(equations);
  m_unknowns.compute(normal.matrix);
  m_eliminated = m_unknowns.matrixL().solve(unknowns.transpose() * equations.taken.causes);
  m_right = m_unknowns.matrixL().solve(normal.right);
  m_chiSquare = std::max(
      0.0, equations.residual.squaredNorm() + equations.priorResiduals.squaredNorm() - m_right.squaredNorm());
  // The number of equations that the unknowns leave is the trace of R.
  m_degreesOfFreedom = static_cast<int>(std::lround(
      static_cast<double>(unknowns.rows()) - m_unknowns.matrixL().solve(unknowns.transpose()).squaredNorm()));
  ByCause causes;
  causes.add({}, 0);
  double evidence = impossible, shares = 0;
  const auto add = [&](Weighed weighed, double log, double odds) {
    evidence = logSum(evidence, log + std::log(odds));
    shares += odds;
    causes.add(std::move(weighed), log + std::log(odds));
  };
  for (const Hypothesis& hypothesis : equations.hypotheses) {
    if (hypothesis.priorOdds == 0) continue;
    Weighed weighed{.cause = hypothesis.cause, .first = hypothesis.first};
    const double log = weigh(hypothesis, weighed);
    add(std::move(weighed), log, hypothesis.priorOdds);
  }
  for (const double scale : noiseScales)
    add({.cause = noiseId, .noise = scale}, logOfNoise(scale, m_chiSquare, m_degreesOfFreedom),
        noise_policy::odds / std::size(noiseScales));
  // Hypotheses that no sighting taken can show have a Bayes factor of 1.
  const double toCome = std::max(0.0, equations.priorOdds - shares);
  if (toCome > 0) evidence = logSum(evidence, std::log(toCome));
  m_logEvidence = evidence - std::log(shares + toCome);
  m_all = causes.all();
}

MatrixXd WeighedCauses::gramOf(Index first, Index count) const {
  const auto own = m_equations.taken.causes.middleCols(first, count);
  const auto gone = m_eliminated.middleCols(first, count);
  MatrixXd gram = own.transpose() * own - gone.transpose() * gone;
  constexpr double rounding = 1e-9;
  for (Index i = 0; i < count; ++i)
    if (gram(i, i) <= rounding * own.col(i).squaredNorm()) {
      gram.row(i).setZero();
      gram.col(i).setZero();
    }
  return gram;
}

VectorXd WeighedCauses::productsOf(Index first, Index count) const {
  return m_equations.taken.causes.middleCols(first, count).transpose() * m_equations.residual -
         m_eliminated.middleCols(first, count).transpose() * m_right;
}

/// Returns ln of the evidence of a hypothesis against no cause, and fills in its weights. These are the mean
/// over the widths; the covariance includes the spread over the widths.
double WeighedCauses::weigh(const Hypothesis& hypothesis, Weighed& weighed) const {
  const MatrixXd gram = gramOf(hypothesis.first, hypothesis.count);
  VectorXd right = productsOf(hypothesis.first, hypothesis.count);
  for (Index i = 0; i < hypothesis.count; ++i)
    if (gram(i, i) == 0) right[i] = 0;
  if (!hypothesis.widths) {
    weighed.weights = VectorXd::Ones(1);
    weighed.covariance = MatrixXd::Zero(1, 1);
    return right[0] - gram(0, 0) / 2;
  }
  if (hypothesis.isBent) {
    const BentFit fit = fitBent(*hypothesis.widths, gram, right, 1);
    const auto slope = bentDerivatives(fit.weights);
    Eigen::Matrix2d precision = slope.transpose() * gram * slope;
    precision.diagonal().array() += 1 / (fit.gain.width * fit.gain.width);
    weighed.weights = bentWeights(fit.weights);
    weighed.covariance = slope * precision.inverse() * slope.transpose();
    return fit.gain.log;
  }
  struct OfWidth {
    double log;
    VectorXd mean;
    MatrixXd covariance;
  };
  std::vector<OfWidth> ofWidths;
  double all = impossible;
  for (const Width& width : *hypothesis.widths) {
    const double weight = 1 / (width.sigma * width.sigma);
    MatrixXd precision = gram;
    precision.diagonal().array() += weight;
    const Eigen::LLT<MatrixXd> factor(precision);
    const MatrixXd covariance = factor.solve(MatrixXd::Identity(hypothesis.count, hypothesis.count));
    const VectorXd mean = covariance * right;
    double log = width.logChance + right.dot(mean) / 2;
    for (Index i = 0; i < hypothesis.count; ++i)
      log += std::log(weight) / 2 - std::log(factor.matrixLLT()(i, i));
    all = logSum(all, log);
    ofWidths.push_back({log, mean, covariance});
  }
  weighed.weights = VectorXd::Zero(hypothesis.count);
  weighed.covariance = MatrixXd::Zero(hypothesis.count, hypothesis.count);
  for (const OfWidth& own : ofWidths) weighed.weights += std::exp(own.log - all) * own.mean;
  for (const OfWidth& own : ofWidths) {
    const VectorXd apart = own.mean - weighed.weights;
    weighed.covariance += std::exp(own.log - all) * (own.covariance + apart * apart.transpose());
  }
  return all;
}

double WeighedCauses::chiSquareAfter(const Weighed& cause) const {
  if (cause.weights.size() == 0) return m_chiSquare / (cause.noise * cause.noise);
  const Index count = cause.weights.size();
  return m_chiSquare - 2 * productsOf(cause.first, count).dot(cause.weights) +
         cause.weights.dot(gramOf(cause.first, count) * cause.weights);
}

WeighedCauses::Predictor::Predictor(const WeighedCauses& causes, const SightingRows& rows) {
  const MatrixXd half = causes.m_unknowns.matrixL().solve(rows.unknowns.transpose());
  m_columns = rows.causes - half.transpose() * causes.m_eliminated;
  m_covariance = half.transpose() * half;
  m_covariance.diagonal().array() += 1;
}

Prediction WeighedCauses::Predictor::under(const Weighed& cause) const {
  const Index count = cause.weights.size();
  if (count == 0) return {VectorXd::Zero(m_covariance.rows()), m_covariance * (cause.noise * cause.noise)};
  const auto columns = m_columns.middleCols(cause.first, count);
  return {columns * cause.weights, m_covariance + columns * cause.covariance * columns.transpose()};
}

}  // namespace alidade
