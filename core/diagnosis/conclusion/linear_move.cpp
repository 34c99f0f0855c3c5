#include "core/diagnosis/conclusion/linear_move.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/adjustment/result/intersection.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/observability/visible_terms.h"
#include "core/effects/catalogue.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

LinearMoves::LinearMoves(const Inquiry& inquiry, Besides besides)
    : m_inquiry(inquiry), m_besides(besides), m_perReading(influencePerSigma(inquiry.base)) {
  // Zeros do not scatter as the readings do.
  for (Index i = 0; i < std::min(m_perReading.size(), inquiry.leftover.readings()); ++i)
    if (!inquiry.leftover.reading(i).isZero) m_ofReadings += m_perReading[i] * m_perReading[i];
  if (besides == Besides::EveryEffect) addEffects();
}

void LinearMoves::addEffects() {
  const Leftover& leftover = m_inquiry.leftover;
  std::vector<ErrorTerm> terms;
  for (const EstimatedTerm& term : everyEffect(*m_inquiry.base.measurement)) {
    const auto& own = m_inquiry.base.options.terms;
    if (std::ranges::find(own, term.term, &EstimatedTerm::term) != own.end()) continue;
    m_effects.terms.push_back(term);
    terms.push_back(term.term);
  }
  const auto count = static_cast<Index>(terms.size());
  const std::vector<EstimatedTerm>& along = m_inquiry.base.options.terms;
  std::vector<ErrorTerm> all = terms;
  for (const EstimatedTerm& term : along) all.push_back(term.term);
  const VisibleTerms visible = withEstimated(visibleTerms(leftover.equations(), all), along);
  const auto& effects = m_effects.terms;
  const auto at = [&](Index i) { return effects[static_cast<std::size_t>(i)]; };
  const auto place = [&](Index i) { return static_cast<Index>(at(i).term); };
  m_effects.gram = MatrixXd::NullaryExpr(count, count, [&](Index i, Index j) {
    return visible.gram(place(i), place(j)) * at(i).priorSigma * at(j).priorSigma;
  });
  m_effects.mean = VectorXd::NullaryExpr(count, [&](Index i) { return at(i).priorValue / at(i).priorSigma; });
  m_effects.right = productsOfEffects(leftover.residual());
  m_effects.influence = productsOfEffects(m_perReading);
}

VectorXd LinearMoves::productsOfEffects(const VectorXd& overReadings) const {
  const VectorXd products = m_inquiry.leftover.productsOfTerms(overReadings);
  return VectorXd::NullaryExpr(static_cast<Index>(m_effects.terms.size()), [&](Index i) {
    const EstimatedTerm& term = m_effects.terms[static_cast<std::size_t>(i)];
    return products[static_cast<Index>(term.term)] * term.priorSigma;
  });
}

const LinearMoves::Columns& LinearMoves::columnsOf(const Part& part) {
  const auto [entry, isNew] = m_columns.try_emplace(part.component);
  Columns& columns = entry->second;
  if (!isNew) return columns;
  const Leftover& leftover = m_inquiry.leftover;
  const MatrixXd whole = m_inquiry.of(part).wholeColumns(leftover);
  columns.influence = whole.transpose() * m_perReading;
  columns.visible = leftover.visible(whole);
  columns.withEffects.resize(static_cast<Index>(m_effects.terms.size()), whole.cols());
  if (!m_effects.terms.empty())
    for (Index i = 0; i < whole.cols(); ++i)
      columns.withEffects.col(i) = productsOfEffects(columns.visible.col(i));
  return columns;
}

bool LinearMoves::isBesides(const Component& component) const {
  const Effect* effect = effectById(component.id());
  if (!effect) return false;
  const EffectParameter& first = effect->parameters.front();
  const auto term = std::ranges::find(m_effects.terms, first.term, &EstimatedTerm::term);
  return term != m_effects.terms.end() && term->priorSigma >= plausibleSize(first);
}

bool LinearMoves::isWhollyBesides(const Part& part) const {
  const Component& component = m_inquiry.of(part);
  return isBesides(component) && component.widthOfFit(part.width, part.weights) <= 1;
}

std::optional<LinearMoves::System> LinearMoves::systemOf(const Explanation& explanation) {
  const Leftover& leftover = m_inquiry.leftover;
  // What is there besides stands first.
  const auto besides = static_cast<Index>(m_effects.terms.size());
  MatrixXd visible(leftover.rows(), 0), withEffects(besides, 0);
  System system{.influence = m_effects.influence, .narrow = VectorXd::Ones(besides)};
  for (const Part& part : explanation.parts) {
    const Component& component = m_inquiry.of(part);
    if (component.isShape()) continue;
    // Such as the other relation of the vertical circle, which is far from its equations at the fit.
    if (component.response() != Response::Linear) return std::nullopt;
    const bool isLeftOut = component.grossErrorAt().has_value();
    double width = component.widthOfFit(part.width, part.weights);
    if (isWhollyBesides(part)) continue;
    if (isBesides(component)) width = std::sqrt(width * width - 1);  // of what it may be beyond
    const Columns& columns = columnsOf(part);
    const Index before = visible.cols(), more = columns.visible.cols(), all = besides + before + more;
    visible.conservativeResize(Eigen::NoChange, before + more);
    visible.rightCols(more) = columns.visible;
    withEffects.conservativeResize(Eigen::NoChange, before + more);
    withEffects.rightCols(more) = columns.withEffects;
    system.influence.conservativeResize(all);
    system.narrow.conservativeResize(all);
    system.influence.tail(more) = columns.influence;
    system.narrow.tail(more).setConstant(isLeftOut ? 0 : 1 / (width * width));
    system.leftOut += isLeftOut ? 1 : 0;
  }
  const Index own = visible.cols(), all = besides + own;
  system.ofNoise = explanation.noisy ? explanation.noise * explanation.noise : 1;
  system.gram.resize(all, all);
  system.right.resize(all);
  if (besides > 0) {
    system.gram.topLeftCorner(besides, besides) = m_effects.gram;
    system.gram.topRightCorner(besides, own) = withEffects;
    system.gram.bottomLeftCorner(own, besides) = withEffects.transpose();
    system.right.head(besides) = m_effects.right + system.ofNoise * m_effects.mean;
  }
  system.gram.bottomRightCorner(own, own) = visible.transpose() * visible;
  system.right.tail(own) = visible.transpose() * leftover.residual();
  system.chiSquare = leftover.chiSquare() + system.ofNoise * m_effects.mean.squaredNorm();
  return system;
}

std::optional<Move> LinearMoves::of(const Explanation& explanation) {
  const std::optional<System> system = systemOf(explanation);
  if (!system) return std::nullopt;
  const Move move = moveOf(explanation, *system);
  if (!std::isfinite(move.shift) || !std::isfinite(move.variance)) return std::nullopt;
  return move;
}

Move LinearMoves::moveOf(const Explanation& explanation, const System& system) const {
  double chiSquare = system.chiSquare, ofReadings = m_ofReadings, ofWidths = 0, ofPattern = 0;
  Move move;
  if (system.right.size() > 0) {
    const Eigen::LDLT<MatrixXd> factor(system.matrix());
    const VectorXd weights = factor.solve(system.right), perWeight = factor.solve(system.influence);
    move.shift = -system.influence.dot(weights);
    ofReadings += perWeight.dot(system.gram * perWeight);
    ofWidths = system.ofNoise * system.ofNoise * system.narrow.dot(perWeight.cwiseAbs2());
    for (Index i = 0; i < static_cast<Index>(m_effects.terms.size()); ++i)
      move.ofEffects.push_back(std::pow(system.ofNoise * perWeight[i], 2));
    chiSquare -= system.right.dot(weights);
  }
  for (const Part& part : explanation.parts)
    if (m_inquiry.of(part).isShape())
      ofPattern = m_perReading.dot(m_inquiry.of(part).times(m_inquiry.leftover, part.weights));
  if (explanation.shaped) chiSquare = explanation.chiSquare;
  const int degreesOfFreedom = m_inquiry.leftover.degreesOfFreedom() - system.leftOut;
  ofReadings *= system.ofNoise * std::pow(noiseScale(chiSquare / system.ofNoise, degreesOfFreedom).factor, 2);
  move.variance = ofReadings + ofWidths + ofPattern * ofPattern;
  return move;
}

namespace {

/// ln ∫ exp(−χ²/2) over the weights of normal equations, but for what others have in common.
double logEvidenceOf(const MatrixXd& matrix, const VectorXd& right, double ofNoise) {
  if (right.size() == 0) return 0;
  const Eigen::LDLT<MatrixXd> factor(matrix);
  return right.dot(factor.solve(right)) / ofNoise / 2 - factor.vectorD().array().max(1e-300).log().sum() / 2;
}

}  // namespace

std::optional<LinearMoves::Stale> LinearMoves::ofStale(const Explanation& explanation,
                                                       std::size_t component) {
  const std::optional<System> holding = systemOf(explanation);
  if (!holding) return std::nullopt;
  Part part;
  part.component = component;
  System system = *holding;
  addLinear(system, explanation, part);
  const auto more = system.right.size() - holding->right.size();
  const Stale stale{moveOf(explanation, system),
                    logEvidenceOf(system.matrix(), system.right, system.ofNoise) -
                        logEvidenceOf(holding->matrix(), holding->right, system.ofNoise) +
                        static_cast<double>(more) * std::log(system.ofNoise) / 2};
  if (!std::isfinite(stale.move.shift) || !std::isfinite(stale.move.variance) ||
      !std::isfinite(stale.logEvidence))
    return std::nullopt;
  return stale;
}

/// Behind all others, at its plausible size. `beside`: what the system holds.
void LinearMoves::addLinear(System& system, const Explanation& beside, const Part& part) {
  const Columns& own = columnsOf(part);
  const Index before = system.right.size(), more = own.visible.cols(), all = before + more;
  MatrixXd with = MatrixXd::Zero(before, more);
  Index row = static_cast<Index>(m_effects.terms.size());
  with.topRows(row) = own.withEffects;
  for (const Part& other : beside.parts) {
    if (m_inquiry.of(other).isShape() || row == before) continue;
    const Columns& columns = columnsOf(other);
    if (isWhollyBesides(other)) continue;
    with.middleRows(row, columns.visible.cols()) = columns.visible.transpose() * own.visible;
    row += columns.visible.cols();
  }
  system.gram.conservativeResize(all, all);
  system.gram.topRightCorner(before, more) = with;
  system.gram.bottomLeftCorner(more, before) = with.transpose();
  system.gram.bottomRightCorner(more, more) = own.visible.transpose() * own.visible;
  for (VectorXd* vector : {&system.right, &system.narrow, &system.influence}) vector->conservativeResize(all);
  system.right.tail(more) = own.visible.transpose() * m_inquiry.leftover.residual();
  system.narrow.tail(more).setOnes();
  system.influence.tail(more) = own.influence;
}

std::optional<double> LinearMoves::logEvidenceOfEffects(const Explanation& explanation) {
  std::optional<System> system = systemOf(explanation);
  if (!system) return std::nullopt;
  for (const Part& part : explanation.parts)
    if (m_inquiry.of(part).isShape()) addPattern(*system, part);
  const auto besides = static_cast<Index>(m_effects.terms.size()), own = system->right.size() - besides;
  const MatrixXd matrix = system->matrix();
  const double together = logEvidenceOf(matrix, system->right, system->ofNoise),
               alone = logEvidenceOf(matrix.bottomRightCorner(own, own), system->right.tail(own),
                                     system->ofNoise),
               ofPriors = static_cast<double>(besides) * std::log(system->ofNoise) / 2 -
                          m_effects.mean.squaredNorm() / 2;
  const double gain = together - alone + ofPriors;
  return std::isfinite(gain) ? std::optional(gain) : std::nullopt;
}

/// As it was found, of any size.
void LinearMoves::addPattern(System& system, const Part& part) {
  const Leftover& leftover = m_inquiry.leftover;
  const VectorXd signature = leftover.visible(VectorXd(m_inquiry.of(part).times(leftover, part.weights)));
  const Index before = system.right.size(), besides = static_cast<Index>(m_effects.terms.size());
  VectorXd with = VectorXd::Zero(before);
  with.head(besides) = productsOfEffects(signature);
  system.gram.conservativeResize(before + 1, before + 1);
  system.gram.col(before).head(before) = with;
  system.gram.row(before).head(before) = with.transpose();
  system.gram(before, before) = signature.squaredNorm();
  for (VectorXd* vector : {&system.right, &system.narrow, &system.influence}) {
    vector->conservativeResize(before + 1);
    (*vector)[before] = 0;
  }
  system.right[before] = signature.dot(leftover.residual());
}

}  // namespace alidade
