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

/// The likeliest hypothesis of each cause, with the total probability of the cause; likeliest cause first.
std::vector<Weighed> byCause(std::vector<Weighed> hypotheses) {
  struct OfCause {
    Weighed likeliest = {.logOdds = impossible};
    double logOdds = impossible;
  };
  std::map<std::string_view, OfCause> causes;
  for (Weighed& hypothesis : hypotheses) {
    OfCause& own = causes[hypothesis.cause];
    own.logOdds = logSum(own.logOdds, hypothesis.logOdds);
    if (hypothesis.logOdds > own.likeliest.logOdds) own.likeliest = std::move(hypothesis);
  }
  double whole = impossible;
  for (const auto& [cause, own] : causes) whole = logSum(whole, own.logOdds);
  std::vector<Weighed> list;
  for (auto& [cause, own] : causes) {
    own.likeliest.probability = std::exp(own.logOdds - whole);
    own.likeliest.logOdds = own.logOdds;
    list.push_back(std::move(own.likeliest));
  }
  std::ranges::stable_sort(list, std::greater{}, &Weighed::logOdds);
  return list;
}

/// Fills in evidence and weights for normal priors of these widths. The weights are the mean over the widths;
/// the covariance includes the spread over the widths.
void weighLinear(Weighed& weighed, const std::vector<Width>& widths, const MatrixXd& gram,
                 const VectorXd& right) {
  const Index count = right.size();
  std::vector<Weighed> ofWidths;
  weighed.logOdds = impossible;
  for (const Width& width : widths) {
    const double weight = 1 / (width.sigma * width.sigma);
    MatrixXd precision = gram;
    precision.diagonal().array() += weight;
    const Eigen::LLT<MatrixXd> factor(precision);
    Weighed& own = ofWidths.emplace_back();
    own.covariance = factor.solve(MatrixXd::Identity(count, count));
    own.weights = own.covariance * right;
    own.logOdds = width.logChance + right.dot(own.weights) / 2;
    for (Index i = 0; i < count; ++i)
      own.logOdds += std::log(weight) / 2 - std::log(factor.matrixLLT()(i, i));
    weighed.logOdds = logSum(weighed.logOdds, own.logOdds);
  }
  weighed.weights = VectorXd::Zero(count);
  weighed.covariance = MatrixXd::Zero(count, count);
  for (const Weighed& own : ofWidths)
    weighed.weights += std::exp(own.logOdds - weighed.logOdds) * own.weights;
  for (const Weighed& own : ofWidths) {
    const VectorXd apart = own.weights - weighed.weights;
    weighed.covariance +=
        std::exp(own.logOdds - weighed.logOdds) * (own.covariance + apart * apart.transpose());
  }
}

/// The same for a bent effect, at its most likely weights.
void weighBent(Weighed& weighed, const std::vector<Width>& widths, const MatrixXd& gram,
               const VectorXd& right) {
  const BentFit fit = fitBent(widths, gram, right, 1);
  const auto slope = bentDerivatives(fit.weights);
  Eigen::Matrix2d precision = slope.transpose() * gram * slope;
  precision.diagonal().array() += 1 / (fit.gain.width * fit.gain.width);
  weighed.logOdds = fit.gain.log;
  weighed.weights = bentWeights(fit.weights);
  weighed.covariance = slope * precision.inverse() * slope.transpose();
}

double logDeterminant(const Eigen::LLT<MatrixXd>& factor) {
  return 2 * factor.matrixLLT().diagonal().array().log().sum();
}

/// ∂(weights of the columns)/∂(unknown sizes): no column for a cause of fixed size.
MatrixXd slopeOf(const Hypothesis& hypothesis, const VectorXd& weights) {
  if (!hypothesis.widths) return MatrixXd::Zero(hypothesis.count, 0);
  if (hypothesis.isBent) return bentDerivatives(weights.head<2>());
  return MatrixXd::Identity(hypothesis.count, hypothesis.count);
}

}  // namespace

double overlapOf(const Prediction& one, const Prediction& other) {
  const Eigen::LLT<MatrixXd> mean((one.covariance + other.covariance) / 2), ofOne(one.covariance),
      ofOther(other.covariance);
  const VectorXd apart = mean.matrixL().solve(one.mean - other.mean);
  const double distance = apart.squaredNorm() / 8 + logDeterminant(mean) / 2 -
                          (logDeterminant(ofOne) + logDeterminant(ofOther)) / 4;
  return std::clamp(std::exp(-distance), 0.0, 1.0);
}

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
  std::vector<Weighed> hypotheses(1);
  double evidence = impossible, shares = 0;
  const auto add = [&](Weighed weighed, double odds) {
    weighed.logOdds += std::log(odds);
    evidence = logSum(evidence, weighed.logOdds);
    shares += odds;
    hypotheses.push_back(std::move(weighed));
  };
  for (const Hypothesis& hypothesis : equations.hypotheses)
    if (hypothesis.priorOdds > 0) add(weigh(hypothesis), hypothesis.priorOdds);
  for (const double scale : noiseScales)
    add({.cause = noiseId, .logOdds = logOfNoise(scale, m_chiSquare, m_degreesOfFreedom), .noise = scale},
        noise_policy::odds / std::size(noiseScales));
  // Hypotheses that no sighting taken can show have a Bayes factor of 1.
  const double toCome = std::max(0.0, equations.priorOdds - shares);
  if (toCome > 0) evidence = logSum(evidence, std::log(toCome));
  m_logEvidence = evidence - std::log(shares + toCome);
  m_all = byCause(std::move(hypotheses));
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

Weighed WeighedCauses::weigh(const Hypothesis& hypothesis) const {
  Weighed weighed{.cause = hypothesis.cause, .first = hypothesis.first};
  const MatrixXd gram = gramOf(hypothesis.first, hypothesis.count);
  const VectorXd right =
      (gram.diagonal().array() == 0).select(0, productsOf(hypothesis.first, hypothesis.count));
  if (!hypothesis.widths) {
    weighed.logOdds = right[0] - gram(0, 0) / 2;
    weighed.weights = VectorXd::Ones(1);
    weighed.covariance = MatrixXd::Zero(1, 1);
  } else if (hypothesis.isBent) {
    weighBent(weighed, *hypothesis.widths, gram, right);
  } else {
    weighLinear(weighed, *hypothesis.widths, gram, right);
  }
  return weighed;
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

SightingEquations withCause(const SightingEquations& equations, const Weighed& cause,
                            const std::vector<std::string>& group) {
  SightingEquations result = equations;
  const Hypothesis& present = *std::ranges::find(equations.hypotheses, cause.first, &Hypothesis::first);
  const MatrixXd slope = slopeOf(present, cause.weights);
  const Index added = slope.cols();
  const auto columnsIn = [&](const SightingRows& rows) {
    return rows.causes.middleCols(present.first, present.count);
  };
  const auto extend = [&](SightingRows& rows) {
    rows.unknowns.conservativeResize(Eigen::NoChange, rows.unknowns.cols() + added);
    rows.unknowns.rightCols(added) = columnsIn(rows) * slope;
  };
  result.residual -= columnsIn(result.taken) * cause.weights;
  extend(result.taken);
  for (SightingRows& rows : result.possible) extend(rows);
  // The prior is centred at the estimate and as wide as the cause is large, so that the readings decide.
  result.appendPriors(VectorXd::Constant(added, 1 / std::max(1.0, cause.weights.head(added).norm())));
  const auto isLeftOut = [&](const Hypothesis& other) {
    if (other.first == present.first) return true;
    return other.cause != grossErrorId && std::ranges::find(group, other.cause) != group.end();
  };
  for (const Hypothesis& other : equations.hypotheses)
    if (isLeftOut(other)) result.priorOdds -= other.priorOdds;
  std::erase_if(result.hypotheses, isLeftOut);
  return result;
}

}  // namespace alidade
