#include "core/diagnosis/session_evidence.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/candidates/session_patterns.h"
#include "core/diagnosis/conclusion/causes.h"
#include "core/diagnosis/evidence/bent_fit.h"
#include "core/diagnosis/observability/look_alikes.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/diagnosis/search/inquiry.h"
#include "core/effects/cause_ids.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::vector<double> listed(const VectorXd& vector) {
  return {vector.begin(), vector.end()};
}

/// Returns the stored inner products of the columns, indexed by `productAt`.
std::vector<double> productsOf(const SharedColumns& shared, const MatrixXd& columns) {
  const auto ofEffects = static_cast<Index>(shared.effectCount());
  const MatrixXd withEffects = columns.transpose() * columns.leftCols(ofEffects);
  std::vector<double> list;
  list.reserve(shared.productAt(shared.count() - 1, shared.count() - 1) + 1);
  for (Index row = 0; row < ofEffects; ++row)
    for (Index column = 0; column <= row; ++column) list.push_back(withEffects(row, column));
  for (const EffectColumns& pattern : shared.all()) {
    if (!pattern.isPattern) continue;
    const auto first = static_cast<Index>(pattern.first), count = static_cast<Index>(pattern.count);
    const MatrixXd own = columns.middleCols(first, count).transpose() * columns.middleCols(first, count);
    for (Index i = 0; i < count; ++i) {
      for (Index column = 0; column < ofEffects; ++column) list.push_back(withEffects(first + i, column));
      for (Index j = 0; j <= i; ++j) list.push_back(own(i, j));
    }
  }
  return list;
}

/// Returns the visible columns of all effects and patterns.
MatrixXd columnsOf(const Inquiry& inquiry, const SharedColumns& shared) {
  MatrixXd all = MatrixXd::Zero(inquiry.leftover.rows(), static_cast<Index>(shared.count()));
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    const Component& component = inquiry.candidates[i];
    if (!component.isEffect()) continue;
    const EffectColumns* own = shared.of(component.id(), inquiry.base.measurement->own.get());
    if (!own) continue;
    const MatrixXd columns = component.visibleColumns(inquiry.leftover);
    if (columns.cols() == static_cast<Index>(own->count))
      all.middleCols(static_cast<Index>(own->first), columns.cols()) = columns;
  }
  const MatrixXd patterns = patternColumns(inquiry.leftover, *inquiry.base.measurement, *inquiry.base.fit);
  all.rightCols(patterns.cols()) = patterns;
  return all;
}

/// Computes the explanations of a session relative to the columns of all effects.
class SessionExplanations {
 public:
  SessionExplanations(const Inquiry& inquiry, const MatrixXd& columns)
      : m_inquiry(inquiry), m_columns(columns), m_right(columns.transpose() * inquiry.leftover.residual()) {}

  /// Returns the empty explanation, then the likeliest explanations: each first without the parts that affect
  /// many readings, then with all its parts.
  std::vector<SessionExplanation> likeliest() {
    constexpr std::size_t mostExplanations = 12, mostKept = 10;
    constexpr double outOfQuestion = 1e-7;
    add({}, 1);
    std::size_t looked = 0;
    for (const Explanation& explanation : m_inquiry.explanations) {
      if (++looked > mostExplanations || explanation.chance < outOfQuestion) break;
      std::vector<Part> others;
      for (const Part& part : explanation.parts)
        if (!isOfMany(part)) others.push_back(part);
      const double noise = explanation.noisy ? explanation.noise : 1;
      add(others, noise);
      add(explanation.parts, noise);
      if (m_explanations.size() >= mostKept) break;
    }
    return std::move(m_explanations);
  }

 private:
  const Inquiry& m_inquiry;
  const MatrixXd& m_columns;
  const VectorXd m_right;
  std::vector<SessionExplanation> m_explanations;
  std::vector<std::vector<std::size_t>> m_keys;

  /// Whether the part affects many readings, so that it may resemble a shared effect.
  bool isOfMany(const Part& part) const {
    const Component& component = m_inquiry.of(part);
    return component.isEffect() || component.isJump() || component.isShape();
  }

  /// Adds an explanation, unless it exists.
  void add(const std::vector<Part>& parts, double noise) {
    std::vector<std::size_t> key{noise > 1 ? std::size_t{1} : 0};
    for (const Part& part : parts) key.push_back(part.component + 2);
    std::ranges::sort(key);
    if (std::ranges::find(m_keys, key) != m_keys.end()) return;
    m_keys.push_back(std::move(key));
    m_explanations.push_back(made(parts, noise));
  }

  SessionExplanation made(const std::vector<Part>& parts, double noise) const {
    const Leftover& leftover = m_inquiry.leftover;
    const double variance = noise * noise, f = leftover.degreesOfFreedom();
    SessionExplanation explanation{.noisy = noise > 1, .noise = noise};
    VectorXd residual = leftover.residual();
    MatrixXd own(leftover.rows(), 0);
    for (const Part& part : parts) {
      const Component& component = m_inquiry.of(part);
      explanation.causes.emplace_back(component.id());
      explanation.holdsPattern = explanation.holdsPattern || isOfMany(part);
      explanation.logOdds += m_inquiry.candidates.groupOf(part.component).logPrior;
      const MatrixXd visible = component.visibleColumns(leftover);
      if (component.response() == Response::AllOrNothing) {
        residual -= visible.col(0);
        continue;
      }
      MatrixXd scaled = visible * part.width;
      if (component.response() == Response::Bent) {  // linearised at its weights
        const VectorXd at = bentWeights(part.weights);
        const auto slope = bentDerivatives(part.weights);
        residual -= visible * (at - slope * part.weights);
        scaled = visible * slope * part.width;
      }
      own.conservativeResize(Eigen::NoChange, own.cols() + scaled.cols());
      own.rightCols(scaled.cols()) = scaled;
    }
    MatrixXd matrix = own.transpose() * own;
    matrix.diagonal().array() += variance;
    const Eigen::LLT<MatrixXd> factor(matrix);
    const MatrixXd taken = factor.matrixL().solve(own.transpose() * m_columns);
    const VectorXd found = factor.matrixL().solve(own.transpose() * residual);
    explanation.chiSquare = std::max(residual.squaredNorm() - found.squaredNorm(), 0.0);
    explanation.right = listed(m_columns.transpose() * residual - taken.transpose() * found);
    explanation.directions = static_cast<std::size_t>(taken.rows());
    const RowMajor rows = taken;
    explanation.taken.assign(rows.data(), rows.data() + rows.size());
    for (Index i = 0; i < matrix.rows(); ++i)
      explanation.logOdds -= std::log(factor.matrixLLT()(i, i)) - std::log(variance) / 2;
    explanation.logOdds += (leftover.chiSquare() - explanation.chiSquare / variance) / 2;
    if (noise > 1) explanation.logOdds += noiseOdds(noise, f);
    return explanation;
  }

  /// ln odds of larger noise: its prior, the width of its posterior, and the smaller weight of all readings.
  static double noiseOdds(double noise, double f) {
    constexpr double range = 2.8;  // width of the searched range of ln noise
    const double known = std::sqrt(M_PI / std::max(f, 1.0));
    return std::log(PriorOdds().noise) + std::log(std::min(known / range, 1.0)) - f * std::log(noise);
  }
};

/// Adds the sums over the circle readings' leftover, in arcseconds.
void addCircleSums(const Inquiry& inquiry, const MatrixXd& columns, SessionEvidence& evidence) {
  const Leftover& leftover = inquiry.leftover;
  VectorXd scales = VectorXd::Zero(leftover.rows());
  for (Index i = 0; i < leftover.readings(); ++i) {
    const LinearReading& reading = leftover.reading(i);
    if (reading.kind == ReadingKind::Slider || !reading.takesPart) continue;
    scales[i] = Angle::fromRadians(reading.sigma).arcseconds();
    ++evidence.circleReadings;
  }
  const VectorXd residual = scales.cwiseProduct(leftover.residual());
  const MatrixXd scaled = scales.asDiagonal() * columns;
  evidence.circleSquares = residual.squaredNorm();
  evidence.circleRight = listed(scaled.transpose() * residual);
  evidence.circleNormal = productsOf(*evidence.columns, scaled);
}

std::vector<double> influenceOf(const Inquiry& inquiry, const SharedColumns& shared) {
  std::vector<double> influence(shared.count(), 0);
  const VectorXd perSigma = influencePerSigma(inquiry.base);
  const SharedProducts perReading(inquiry.leftover, perSigma);
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    const Component& component = inquiry.candidates[i];
    if (!component.isEffect() || component.response() == Response::AllOrNothing) continue;
    const EffectColumns* own = shared.of(component.id(), inquiry.base.measurement->own.get());
    if (!own) continue;
    const VectorXd of = component.wholeProducts(perReading);
    const Index count = std::min(of.size(), static_cast<Index>(own->effect->parameters.size()));
    std::copy_n(of.begin(), count, influence.begin() + static_cast<std::ptrdiff_t>(own->first));
  }
  return influence;
}

using Square = Eigen::Map<const RowMajor>;

Square squareOf(std::span<const double> gram, std::span<const double> right) {
  return {gram.data(), std::ssize(right), std::ssize(right)};
}

Eigen::Map<const VectorXd> vectorOf(std::span<const double> list) {
  return {list.data(), std::ssize(list)};
}

}  // namespace

Result<SessionEvidence, DiagnosisFault> evidenceOf(const Measurement& measurement,
                                                   std::shared_ptr<const SharedColumns> shared,
                                                   const DiagnosisOptions& options,
                                                   const std::stop_token& stop) {
  for (const std::string& id : options.without)
    if (!isDiagnosable(id, measurement)) return DiagnosisFault(UnknownCause{id});
  const SessionFit fit = fitSession(measurement);
  auto model = modelOf(measurement, fit);
  if (!model) return DiagnosisFault(model.problem());
  const Inquiry inquiry = inquire(*std::move(model), options, stop);
  if (stop.stop_requested()) return DiagnosisFault(Stopped{});
  if (const auto fault = undetermined(inquiry)) return DiagnosisFault(*fault);
  const MatrixXd columns = columnsOf(inquiry, *shared);
  SessionEvidence evidence;
  evidence.columns = std::move(shared);
  evidence.normal = productsOf(*evidence.columns, columns);
  evidence.explanations = SessionExplanations(inquiry, columns).likeliest();
  evidence.chiSquare = inquiry.leftover.chiSquare();
  evidence.degreesOfFreedom = inquiry.leftover.degreesOfFreedom();
  addCircleSums(inquiry, columns, evidence);
  evidence.influence = influenceOf(inquiry, *evidence.columns);
  const Answer answer = conclude(inquiry);
  evidence.causes = causesOf(inquiry, answer);
  evidence.verdict = verdictOf(answer, evidence.causes);
  return evidence;
}

ColumnGain columnGain(Response response, std::span<const double> gram, std::span<const double> right,
                      std::span<const double> sigmas) {
  std::vector<Width> widths;
  for (const double sigma : sigmas) widths.push_back({sigma, -std::log(static_cast<double>(sigmas.size()))});
  const MatrixXd matrix = squareOf(gram, right);
  const VectorXd vector = vectorOf(right);
  if (response == Response::AllOrNothing) return {vector[0] - matrix(0, 0) / 2, 1, {}};
  if (response == Response::Bent) {
    const BentFit fit = fitBent(widths, matrix, vector, 1);
    return {fit.gain.log, fit.gain.width, listed(fit.weights)};
  }
  const Gain gain = gainOf(widths, matrix, vector, 1);
  MatrixXd posterior = matrix;
  posterior.diagonal().array() += 1 / (gain.width * gain.width);
  return {gain.log, gain.width, listed(posterior.ldlt().solve(vector))};
}

double leastDifference(Response response, std::span<const double> gram, std::span<const double> right,
                       double square) {
  const MatrixXd matrix = squareOf(gram, right);
  const VectorXd vector = vectorOf(right);
  if (response == Response::Bent) return differenceFromBent(matrix, vector, square);
  if (response == Response::AllOrNothing)
    return std::sqrt(std::max(square - 2 * vector[0] + matrix(0, 0), 0.0));
  constexpr double rounding = 1e-11, invisible = 1e-9;
  const VectorXd lengths = matrix.diagonal().cwiseMax(0).cwiseSqrt();
  const VectorXd scale = (lengths.array() < invisible).select(0, lengths.cwiseMax(invisible).cwiseInverse());
  Eigen::ColPivHouseholderQR<MatrixXd> normal(scale.asDiagonal() * matrix * scale.asDiagonal());
  normal.setThreshold(rounding);
  const VectorXd weights = scale.cwiseProduct(normal.solve(scale.cwiseProduct(vector)));
  return std::sqrt(std::clamp(square - weights.dot(2 * vector - matrix * weights), 0.0, square));
}

double hardlySeparated() {
  return thresholds.hardlyDifferent;
}

double clearlySeparated() {
  return thresholds.clearlyDifferent;
}

double priorOddsOfEffect() {
  return PriorOdds().effect;
}

}  // namespace alidade
