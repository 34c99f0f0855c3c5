#include "core/diagnosis/conclusion/weighed_explanations.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/adjustment/result/intersection.h"
#include "core/base/square.h"
#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/observability/visible_terms.h"
#include "core/effects/catalogue.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

bool isAmong(const std::vector<EstimatedTerm>& terms, ErrorTerm term) {
  return std::ranges::find(terms, term, &EstimatedTerm::term) != terms.end();
}

/// The terms of the effects that the model does not estimate yet.
std::vector<EstimatedTerm> effectsBeyond(const GapModel& base) {
  std::vector<EstimatedTerm> terms = everyEffect(*base.measurement);
  std::erase_if(terms, [&](const EstimatedTerm& term) { return isAmong(base.options.terms, term.term); });
  return terms;
}

/// The all-or-nothing terms in the model.
std::vector<EstimatedTerm> allOrNothingTerms(const GapModel& at) {
  std::vector<EstimatedTerm> terms;
  for (const EstimatedTerm& term : at.options.terms)
    if (const Effect* effect = effectOf(term.term, *at.measurement);
        effect && effect->response == Response::AllOrNothing)
      terms.push_back(term);
  return terms;
}

/// The leftover of the base's equations, linearised at the fit `at`. The contribution of the effects in `at`
/// is added back to the residuals.
Leftover leftoverAt(const GapModel& base, const GapModel& at, const std::vector<EstimatedTerm>& effects) {
  const auto indexIn = [](const JointFit& fit, ErrorTerm term) { return fit.indexOf(term); };
  JointFit fit = *at.fit;
  JointFitOptions options = base.options;
  for (const EstimatedTerm& term : allOrNothingTerms(at))
    if (!isAmong(options.terms, term.term)) options.terms.push_back(term);
  const std::vector<EstimatedTerm> inModel = options.terms;
  for (const EstimatedTerm& term : at.options.terms)
    if (isOfJump(term.term)) fit.values[indexIn(fit, term.term)] = 0;
  std::ranges::copy(effects, std::back_inserter(options.terms));
  Linearised equations = linearise(*base.measurement, fit, options);
  for (const EstimatedTerm& effect : effects) {
    double& value = equations.termValues[static_cast<std::size_t>(effect.term)];
    for (std::size_t i = 0; i < equations.readings.size(); ++i)
      equations.readings[i].residual += equations.ofTerm(i, effect.term) * value;
    value = 0;
  }
  return Leftover(std::move(equations), inModel);
}

double logDeterminant(const Eigen::LDLT<MatrixXd>& factor) {
  return factor.vectorD().array().max(1e-300).log().sum();
}

}  // namespace

/// The normal equations of an explanation: its own columns, and the effects' columns after elimination of its
/// own columns.
struct WeighedExplanations::System {
  const Explanation* explanation = nullptr;
  std::vector<const Columns*> own = {};
  Eigen::LDLT<MatrixXd> factor = {};  ///< factor of the own columns' normal matrix
  VectorXd narrow = {};               ///< 1/width² of the own weights; 0 for an excluded reading
  VectorXd right = {}, influence = {};
  MatrixXd withEffects = {};  ///< effects × own
  MatrixXd effects = {};
  VectorXd effectsRight = {}, effectsInfluence = {}, leastWidths = {};
  double quadratic = 0, shift = 0, variance = 0, logScale = 0;  ///< of the own columns alone
  double ofNoise = 1;
  int leftOut = 0;  ///< number of excluded readings
};

WeighedExplanations::WeighedExplanations(const Inquiry& inquiry)
    : m_inquiry(inquiry),
      m_perReading(influencePerSigma(inquiry.base)),
      m_ofReadings(varianceOfReadings(inquiry.leftover, m_perReading)),
      m_terms(effectsBeyond(inquiry.base)) {
  if (const auto estimate = estimateOf(inquiry.base)) m_start = estimate->value;
  addEffects();
}

void WeighedExplanations::alsoAt(const GapModel& at, const Explanation& explanation,
                                 const EffectScales& scales) {
  const std::optional<IntersectionEstimate> estimate = estimateOf(at);
  if (!estimate || !at.fit->converged() || at.noise != 1 || isLarge(*m_inquiry.base.measurement)) return;
  auto own = std::make_shared<WeighedExplanations>(m_inquiry);
  own->m_own.emplace(leftoverAt(m_inquiry.base, at, m_terms));
  for (const EstimatedTerm& term : allOrNothingTerms(at)) own->m_allOrNothing.push_back(term.term);
  own->m_start = 0;
  own->addEffects();
  const std::optional<System> system = own->systemOf(explanation);
  if (!system) return;
  own->m_start = estimate->value - own->weighedAt(*system, scales).value;
  // Without large causes, the base is far from `at`. The shift makes its Δd agree with the Δd of `at`.
  if (const std::optional<System> here = systemOf(explanation))
    m_start += estimate->value - weighedAt(*here, scales).value;
  m_at = std::move(own);
}

void WeighedExplanations::addEffects() {
  for (const EstimatedTerm& term : m_terms)
    m_effects.push_back(effectOf(term.term, *m_inquiry.base.measurement));
  m_gram = isLarge(*m_inquiry.base.measurement) ? gramOfMany() : gramOfColumns();
  m_right = productsOfEffects(leftover().residual());
  m_influence = productsOfEffects(m_perReading);
}

MatrixXd WeighedExplanations::gramOfColumns() const {
  MatrixXd columns(leftover().readings(), std::ssize(m_terms));
  Index column = 0;
  for (const EstimatedTerm& term : m_terms)
    columns.col(column++) = leftover().column(term.term) * term.priorSigma;
  columns = leftover().visible(columns);
  return columns.transpose() * columns;
}

/// Avoids a matrix of all columns, which can fill the memory in a large session.
MatrixXd WeighedExplanations::gramOfMany() const {
  const std::vector<EstimatedTerm>& along = m_inquiry.base.options.terms;
  std::vector<ErrorTerm> all;
  for (const EstimatedTerm& term : m_terms) all.push_back(term.term);
  for (const EstimatedTerm& term : along) all.push_back(term.term);
  const VisibleTerms visible = withEstimated(visibleTerms(leftover().equations(), all), along);
  const auto count = std::ssize(m_terms);
  const auto at = [&](Index i) { return m_terms[static_cast<std::size_t>(i)]; };
  return MatrixXd::NullaryExpr(count, count, [&](Index i, Index j) {
    return visible.gram(static_cast<Index>(at(i).term), static_cast<Index>(at(j).term)) * at(i).priorSigma *
           at(j).priorSigma;
  });
}

VectorXd WeighedExplanations::productsOfEffects(const VectorXd& overReadings) const {
  const VectorXd products = leftover().productsOfTerms(overReadings);
  return VectorXd::NullaryExpr(static_cast<Index>(m_terms.size()), [&](Index i) {
    const EstimatedTerm& term = m_terms[static_cast<std::size_t>(i)];
    return products[static_cast<Index>(term.term)] * term.priorSigma;
  });
}

const WeighedExplanations::Columns& WeighedExplanations::columnsOf(const Part& part) {
  const auto [entry, isNew] = m_columns.try_emplace(part.component);
  Columns& columns = entry->second;
  if (!isNew) return columns;
  const Component& component = m_inquiry.of(part);
  // All columns of a pattern can fill the memory in a large session: their weighted sum replaces them.
  const bool asFound = component.isShape() && isLarge(*m_inquiry.base.measurement);
  columns.whole = asFound ? MatrixXd(component.times(m_inquiry.leftover, part.weights))
                          : component.wholeColumns(m_inquiry.leftover);
  columns.visible = leftover().visible(columns.whole);
  columns.influence = columns.whole.transpose() * m_perReading;
  columns.right = columns.visible.transpose() * leftover().residual();
  columns.withEffects.resize(static_cast<Index>(m_terms.size()), columns.whole.cols());
  for (Index i = 0; i < columns.whole.cols(); ++i)
    columns.withEffects.col(i) = productsOfEffects(columns.visible.col(i));
  return columns;
}

std::optional<WeighedExplanations::System> WeighedExplanations::systemOf(const Explanation& explanation) {
  constexpr int mostRounds = 4;
  constexpr double settled = 0.02;  // change of ln noise
  double noise = explanation.noisy ? explanation.noise : 1;
  std::optional<System> system = systemOf(explanation, noise);
  for (int round = 0; explanation.noisy && system && round < mostRounds; ++round) {
    const double left = weighedAt(*system, {}).noise;
    if (std::abs(std::log(left / noise)) < settled) break;
    noise = left;
    system = systemOf(explanation, noise);
  }
  return system;
}

std::optional<WeighedExplanations::System> WeighedExplanations::systemOf(const Explanation& explanation,
                                                                         double noise) {
  const auto effects = static_cast<Index>(m_terms.size());
  System system{
      .explanation = &explanation, .leastWidths = VectorXd::Zero(effects), .ofNoise = square(noise)};
  std::vector<double> narrow;
  std::size_t matched = 0;
  const auto isInFit = [&](const Component& component) {
    return std::ranges::any_of(m_allOrNothing,
                               [&](ErrorTerm term) { return effectOf(term)->id == component.id(); });
  };
  for (const Part& part : explanation.parts) {
    const Component& component = m_inquiry.of(part);
    if (component.response() == Response::AllOrNothing) {
      if (isInFit(component))
        ++matched;
      else
        return std::nullopt;
      continue;
    }
    const double width = component.widthOfFit(part.width, part.weights);
    const Effect* const effect =
        component.isEffect() ? effectById(component.id(), *m_inquiry.base.measurement) : nullptr;
    bool isOfEffects = false;
    for (Index i = 0; i < effects; ++i)
      if (effect && m_effects[static_cast<std::size_t>(i)] == effect) {
        system.leastWidths[i] = width;
        isOfEffects = true;
      }
    if (isOfEffects) continue;
    const bool isLeftOut = component.grossErrorAt().has_value();
    system.leftOut += isLeftOut ? 1 : 0;
    system.own.push_back(&columnsOf(part));
    narrow.insert(narrow.end(), static_cast<std::size_t>(system.own.back()->whole.cols()),
                  isLeftOut ? 0 : 1 / square(width));
  }
  if (matched != m_allOrNothing.size()) return std::nullopt;
  const auto own = std::ssize(narrow);
  system.narrow = Eigen::Map<const VectorXd>(narrow.data(), own);
  system.right.resize(own);
  system.influence.resize(own);
  system.withEffects.resize(effects, own);
  MatrixXd visible(leftover().rows(), own);
  Index first = 0;
  for (const Columns* columns : system.own) {
    const Index count = columns->whole.cols();
    visible.middleCols(first, count) = columns->visible;
    system.right.segment(first, count) = columns->right;
    system.influence.segment(first, count) = columns->influence;
    system.withEffects.middleCols(first, count) = columns->withEffects;
    first += count;
  }
  system.effects = m_gram;
  system.effectsRight = m_right;
  system.effectsInfluence = m_influence;
  if (own == 0) return system;
  MatrixXd matrix = visible.transpose() * visible;
  matrix.diagonal() += system.ofNoise * system.narrow;
  system.factor.compute(matrix);
  const VectorXd weights = system.factor.solve(system.right),
                 perWeight = system.factor.solve(system.influence);
  system.quadratic = system.right.dot(weights);
  system.shift = -system.influence.dot(weights);
  system.variance = system.influence.dot(perWeight);
  system.logScale = -logDeterminant(system.factor) / 2;
  for (const double each : narrow)
    if (each > 0) system.logScale += std::log(each * system.ofNoise) / 2;
  system.effects -= system.withEffects * system.factor.solve(system.withEffects.transpose());
  system.effectsRight -= system.withEffects * weights;
  system.effectsInfluence -= system.withEffects * perWeight;
  const bool isFinite = std::isfinite(system.quadratic) && system.effects.allFinite();
  return isFinite ? std::optional(system) : std::nullopt;
}

VectorXd WeighedExplanations::widthsOf(const System& system, const EffectScales& scales) const {
  return VectorXd::NullaryExpr(static_cast<Index>(m_terms.size()), [&](Index i) {
    return std::max(scales.of(*m_effects[static_cast<std::size_t>(i)]), system.leastWidths[i]);
  });
}

WeighedExplanation WeighedExplanations::weighedAt(const System& system, const EffectScales& scales) const {
  const double v = system.ofNoise;
  const VectorXd widths = widthsOf(system, scales);
  MatrixXd matrix = system.effects;
  matrix.diagonal() += v * widths.cwiseAbs2().cwiseInverse();
  const Eigen::LLT<MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success) return {.scales = scales, .logOdds = impossible};  // rounding errors
  const VectorXd weights = factor.solve(system.effectsRight),
                 perWeight = factor.solve(system.effectsInfluence);
  const double quadratic = system.quadratic + system.effectsRight.dot(weights);
  const double all = v * (system.variance + system.effectsInfluence.dot(perWeight));
  const VectorXd ofEffects = square(v) * perWeight.cwiseQuotient(widths).cwiseAbs2();
  double ofWidths = ofEffects.sum();
  if (system.narrow.size() > 0) {
    const VectorXd ofOwn = system.factor.solve(system.influence - system.withEffects.transpose() * perWeight);
    ofWidths += square(v) * system.narrow.dot(ofOwn.cwiseAbs2());
  }
  const double chiSquare = leftover().chiSquare() - quadratic;
  const int degreesOfFreedom = leftover().degreesOfFreedom();
  const double noise = noiseScale(chiSquare / v, degreesOfFreedom - system.leftOut).factor;
  const NoiseEvidence ofNoise =
      evidenceOfNoise(system.explanation->noisy, chiSquare, degreesOfFreedom, std::sqrt(v));
  const double ofReadings = v * m_ofReadings + std::max(all - ofWidths, 0.0);
  return {scales,
          system.logScale - factor.matrixLLT().diagonal().array().max(1e-150).log().sum() -
              widths.array().log().sum() + static_cast<double>(widths.size()) * std::log(v) / 2 +
              quadratic / v / 2 - leftover().chiSquare() / v / 2 - degreesOfFreedom * std::log(v) / 2 +
              ofNoise.log,
          m_start + system.shift - system.effectsInfluence.dot(weights),
          square(noise) * ofReadings + ofWidths,
          all,
          std::vector<double>(ofEffects.begin(), ofEffects.end()),
          ofNoise.likeliest};
}

std::vector<WeighedExplanation> WeighedExplanations::of(const Explanation& explanation) {
  const std::optional<System> system = systemOf(explanation);
  const std::optional<System> there = m_at ? m_at->systemOf(explanation) : std::nullopt;
  if (!system && !there) return {};
  // The search found the posterior odds without effects: the evidence with effects replaces `alone`.
  WeighedExplanations& own = system ? *this : *m_at;
  const std::optional<System> found = explanation.noisy ? own.systemOf(explanation, explanation.noise)
                                      : system          ? system
                                                        : there;
  const double alone = own.weighedAt(*found, noEffect).logOdds;
  // Uses the linearisation that makes the explanation likelier, with effects of plausible size.
  const bool isThere =
      there && (!system || m_at->weighedAt(*there, {}).logOdds > weighedAt(*system, {}).logOdds);
  std::vector<WeighedExplanation> explanations;
  for (const auto& [scales, probability] : possibleScales()) {
    WeighedExplanation weighed = isThere ? m_at->weighedAt(*there, scales) : weighedAt(*system, scales);
    weighed.logOdds += explanation.logPosteriorOdds - alone + std::log(probability);
    if (!std::isfinite(weighed.logOdds) || !std::isfinite(weighed.value) || !std::isfinite(weighed.variance))
      continue;
    explanations.push_back(std::move(weighed));
  }
  return explanations;
}

std::optional<WeighedExplanation> WeighedExplanations::of(const Explanation& explanation,
                                                          const EffectScales& scales) {
  if (m_at)
    if (const auto there = m_at->of(explanation, scales)) return there;
  const std::optional<System> system = systemOf(explanation);
  if (!system) return std::nullopt;
  return weighedAt(*system, scales);
}

std::optional<double> WeighedExplanations::logEvidenceOf(const Explanation& explanation, const Part& more) {
  Explanation with = explanation;
  with.parts.push_back(more);
  const std::optional<WeighedExplanation> before = of(explanation, noEffect), after = of(with, noEffect);
  if (!before || !after) return std::nullopt;
  return after->logOdds - before->logOdds;
}

VectorXd WeighedExplanations::takenByPattern(const Explanation& explanation, const EffectScales& scales) {
  const std::optional<System> system = systemOf(explanation);
  VectorXd taken = VectorXd::Zero(leftover().readings());
  if (!system || !explanation.shaped) return taken;
  MatrixXd matrix = system->effects;
  matrix.diagonal() += system->ofNoise * widthsOf(*system, scales).cwiseAbs2().cwiseInverse();
  const VectorXd ofEffects = matrix.ldlt().solve(system->effectsRight);
  const VectorXd own = system->factor.solve(system->right - system->withEffects.transpose() * ofEffects);
  const MatrixXd& pattern = system->own.back()->whole;  // the pattern is the last part
  return pattern * own.tail(pattern.cols());
}

}  // namespace alidade
