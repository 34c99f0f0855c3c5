#include "core/diagnosis/conclusion/measured.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/adjustment/result/intersection.h"
#include "core/adjustment/result/uncertain_length.h"
#include "core/base/square.h"
#include "core/base/statistics.h"
#include "core/diagnosis/conclusion/afterwards.h"
#include "core/diagnosis/conclusion/measured_budget.h"
#include "core/diagnosis/conclusion/weighed_explanations.h"
#include "core/diagnosis/conclusion/with_forms.h"
#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/diagnosis/search/explained_model.h"
#include "core/effects/catalogue.h"
#include "core/effects/known_sizes.h"

namespace alidade {

namespace {

/// The offset across the plane, and its covariance with Δd, mm².
struct Across {
  MeasuredLength length;
  double covariance = 0;
};

/// The estimate of the plane's offset without the prior N(p₀, p²) of its plausible size. The estimate
/// contains the prior with the share g = Q/p²; the rest is (value − g p₀)/(1 − g). A known size stays in it.
std::optional<Across> acrossOf(const GapModel& model, const std::vector<double>& weights) {
  constexpr ErrorTerm offset = ErrorTerm::PlaneOffset;
  const JointFit& fit = *model.fit;
  const auto term = std::ranges::find(model.options.terms, offset, &EstimatedTerm::term);
  if (term == model.options.terms.end()) return std::nullopt;
  const Unknown unknown{.kind = Unknown::Kind::Error, .arc = 0, .term = offset};
  const std::size_t index = fit.indexOf(unknown);
  const std::vector<double> own = unitWeights(fit, unknown);
  const NoiseScale noise = noiseScale(fit);
  const std::vector<BudgetEntry> budget = budgetOf(fit, own, noise.factor);
  const bool isKnown = knownOf(*model.measurement, effectOf(offset)->parameters.front()).has_value();
  const double ofPrior = isKnown ? 0 : fit.cofactor(index, index) / square(term->priorSigma);
  if (!(ofPrior < thresholds.ofPriorOnly)) return std::nullopt;
  const double withPrior = covarianceWith(fit.cofactor, weights, index);
  const double ofReadings = 1 - ofPrior;
  const double variance = square(combined(budget)) - square(ofPrior * term->priorSigma);
  const double sigma = std::sqrt(std::max(variance, 0.0)) / ofReadings;
  const DegreesOfFreedom freedom = effectiveDegreesOfFreedom(
      sigma, std::min(scaledPart(budget) / ofReadings, sigma), noise.degreesOfFreedom);
  return Across{{(fit.values[index] - ofPrior * term->priorValue) / ofReadings, sigma,
                 coverageFactor(model.measurement->coverage, freedom) * sigma},
                (covarianceOf(fit, weights, own, noise.factor) - ofPrior * withPrior) / ofReadings};
}

MeasuredLength distanceOf(const IntersectionEstimate& inPlane, const Across& across) {
  const UncertainLength length = lengthOf({.x = inPlane.value,
                                           .y = across.length.value,
                                           .varianceX = square(inPlane.sigma),
                                           .varianceY = square(across.length.sigma),
                                           .covariance = across.covariance});
  const double factor =
      std::max(inPlane.expanded / inPlane.sigma, across.length.expanded / across.length.sigma);
  return {length.value, length.sigma, factor * length.sigma};
}

std::optional<FittedExplanation> byFit(const GapModel& model, const EffectScales& scales) {
  const JointFit& fit = *model.fit;
  const std::optional<Intersection> found = intersect(*model.measurement, fit);
  if (!found) return std::nullopt;
  FittedExplanation fitted{estimateOf(*found), scales, {}, {}, noiseScale(fit)};
  const std::vector<double> weights =
      intersectionWeights(fit, *arcAt(*model.measurement, 0), *arcAt(*model.measurement, 180));
  for (std::size_t index = 0; index < fit.unknowns.size(); ++index) {
    const Unknown& unknown = fit.unknowns[index];
    if (unknown.kind != Unknown::Kind::Error) continue;
    fitted.terms[unknown.term] = {fit.priorSigmas[index], varianceOfPrior(fit, fit.cofactor, weights, index)};
  }
  std::ranges::copy_if(found->budget, std::back_inserter(fitted.others), [](const BudgetEntry& entry) {
    return entry.source != UncertaintySource::PlausibleSizes;
  });
  return fitted;
}

/// The offset across the plane from `model`, the fit with every effect at its plausible size. The measured
/// part of the offset does not depend on the sizes of the other effects.
std::optional<Across> acrossOf(const GapModel& model) {
  if (!intersect(*model.measurement, *model.fit)) return std::nullopt;
  return acrossOf(
      model, intersectionWeights(*model.fit, *arcAt(*model.measurement, 0), *arcAt(*model.measurement, 180)));
}

/// Adds the variance of each jump term to that of the drift of the same circle. If the answer contains no
/// jump, the jump terms are the part of a drift during the pause (`addPause`).
std::map<ErrorTerm, TermShare> withPausesInDrifts(std::map<ErrorTerm, TermShare> terms) {
  using enum ErrorTerm;
  for (const auto& [step, drift] :
       {std::pair{HorizontalJump, HorizontalDrift}, std::pair{VerticalJump, VerticalDrift}}) {
    const auto ofPause = terms.find(step), ofDrift = terms.find(drift);
    if (ofPause == terms.end() || ofDrift == terms.end()) continue;
    ofDrift->second.variance += ofPause->second.variance;
    terms.erase(ofPause);
  }
  return terms;
}

/// Computes Δd, measured, for an explanation with every effect.
class Measured {
 public:
  Measured(const Inquiry& inquiry, const Answer& answer)
      : m_inquiry(inquiry), m_answer(answer), m_weighed(inquiry), m_whole(answer.explanation) {
    if (const Explanation* const found = explanationOf(inquiry, answer)) m_whole = *found;
    m_model = answer.kind == Answer::Kind::Several || m_whole.shaped
                  ? modelWith(inquiry.base, rest(), inquiry.candidates, inquiry.leftover)
                  : answer.after;
    m_scales = averageScales(m_weighed.of(m_whole));
    if (isLarge(*inquiry.base.measurement)) return;
    if (m_whole.shaped)
      m_model.measurement = std::make_shared<const Measurement>(
          withoutPattern(*m_model.measurement, inquiry, m_weighed.takenByPattern(m_whole, m_scales)));
    m_every = withEveryEffect(m_model);
    m_fit = withEveryEffect(m_model, m_scales);
    m_weighed.alsoAt(m_fit, m_whole, m_scales);
  }

  std::optional<MeasuredWithEffects> measured() {
    std::optional<FittedExplanation> fitted;
    if (!isLarge(*m_inquiry.base.measurement)) fitted = byFit(m_fit, m_scales);
    if (!fitted) fitted = byMoves();
    if (!fitted) return std::nullopt;
    const auto isJump = [&](const Part& part) { return m_inquiry.of(part).isJump(); };
    if (std::ranges::none_of(m_whole.parts, isJump))
      fitted->terms = withPausesInDrifts(std::move(fitted->terms));
    const IntersectionEstimate estimate = averaged(fitted->estimate);
    MeasuredIntersection measured{estimate, budgetOf(*fitted, *m_inquiry.base.measurement, estimate)};
    if (const auto across = m_every.fit ? acrossOf(m_every) : std::nullopt) {
      measured.across = across->length;
      measured.distance = distanceOf(estimate, *across);
    }
    return MeasuredWithEffects{std::move(measured),
                               m_averaged.empty() ? m_scales : averageScales(m_averaged)};
  }

 private:
  const Inquiry& m_inquiry;
  const Answer& m_answer;
  WeighedExplanations m_weighed;
  Explanation m_whole;    ///< the answer's explanation, with its pattern
  EffectScales m_scales;  ///< average over the scales of `m_whole`
  std::vector<WeighedExplanation> m_averaged;
  GapModel m_model, m_every, m_fit;  ///< without effects; with all at plausible size; with all at `m_scales`

  /// The explanation without its pattern.
  Explanation rest() const {
    Explanation rest = m_whole;
    if (rest.shaped) rest.parts.pop_back();  // the pattern is the last part
    rest.shaped = false;
    return rest;
  }

  /// The root mean square of the scales, weighted by the odds.
  static EffectScales averageScales(const std::vector<WeighedExplanation>& weighed) {
    if (weighed.empty()) return {};
    const double most = std::ranges::max(weighed, {}, &WeighedExplanation::logOdds).logOdds;
    double all = 0, guideway = 0, instrument = 0, time = 0;
    for (const WeighedExplanation& one : weighed) {
      const double odds = std::exp(one.logOdds - most);
      all += odds;
      guideway += odds * square(one.scales.guideway);
      instrument += odds * square(one.scales.instrument);
      time += odds * square(one.scales.time);
    }
    return {std::sqrt(guideway / all), std::sqrt(instrument / all), std::sqrt(time / all)};
  }

  /// The answer's fit plus the shift and variance due to pattern and effects.
  std::optional<FittedExplanation> byMoves() {
    const auto with = m_weighed.of(m_whole, m_scales), without = m_weighed.of(m_answer.explanation, noEffect);
    const std::optional<Intersection> found = intersect(*m_answer.after.measurement, *m_answer.after.fit);
    if (!with || !without || !found) return std::nullopt;
    FittedExplanation fitted{
        estimateOf(*found), m_scales, {}, found->budget, noiseScale(*m_answer.after.fit)};
    IntersectionEstimate& estimate = fitted.estimate;
    const double factor = estimate.expanded / estimate.sigma;
    double ofTerms = 0;
    for (std::size_t i = 0; i < with->ofEffects.size(); ++i) {
      const EstimatedTerm& term = m_weighed.effects()[i];
      fitted.terms[term.term] = {
          term.priorSigma * m_scales.of(*effectOf(term.term, *m_inquiry.base.measurement)),
          with->ofEffects[i]};
      ofTerms += with->ofEffects[i];
    }
    estimate.value += with->value - without->value;
    const double more = std::max(with->variance - without->variance, ofTerms);
    estimate.sigma = std::sqrt(square(estimate.sigma) + more);
    estimate.expanded = factor * estimate.sigma;
    estimate.explanations = {{1, estimate.value, estimate.sigma}};
    fitted.others.push_back({UncertaintySource::ModelEffects, std::sqrt(more - ofTerms)});
    return fitted;
  }

  /// The average over every explanation with each scale of the effects.
  IntersectionEstimate averaged(IntersectionEstimate own) {
    const std::optional<WeighedExplanation> ofWhole = m_weighed.of(m_whole, m_scales);
    if (!ofWhole || !(own.sigma > 0)) return own;
    if (m_whole.shaped && !isLarge(*m_inquiry.base.measurement)) {
      const std::optional<WeighedExplanation> ofRest = m_weighed.of(rest(), m_scales);
      own = widerBy(own, ofRest ? ofWhole->ofWeights - ofRest->ofWeights : 0);
    }
    constexpr double least = 1e-4;
    for (const Explanation& explanation : explanations())
      std::ranges::move(m_weighed.of(explanation), std::back_inserter(m_averaged));
    if (m_averaged.empty()) return own;
    const double most = std::ranges::max(m_averaged, {}, &WeighedExplanation::logOdds).logOdds;
    std::vector<Possible> possible;
    for (const WeighedExplanation& one : m_averaged)
      if (const double odds = std::exp(one.logOdds - most); odds > least)
        possible.push_back({odds, one.value - ofWhole->value, one.variance - ofWhole->variance});
    return averagedOver(own, possible, m_inquiry.base.measurement->coverage);
  }

  /// The explanations to average over: those of the search, variants of the answer with a look-alike, and
  /// variants with an outdated known size. An explanation by one gross error or one jump counts even if it is
  /// unlikely, since the search weighed it without the effects.
  std::vector<Explanation> explanations() {
    std::vector<Explanation> all = withRivals(m_answer, m_whole);
    for (const Explanation& explanation : m_inquiry.explanations) {
      const bool isAlone = explanation.parts.size() == 1 && !m_inquiry.of(explanation.parts[0]).isEffect() &&
                           !explanation.shaped;
      const bool counts =
          explanation.chance >= thresholds.leastAveraged || explanation.parts.empty() || isAlone;
      const auto isThat = [&](const Explanation& other) { return areAlike(other, explanation); };
      if (counts && isInAverage(explanation, m_answer) && std::ranges::none_of(all, isThat))
        all.push_back(explanation);
    }
    addStale(all);
    return all;
  }

  void addStale(std::vector<Explanation>& all) {
    for (std::size_t i = 0; i < m_inquiry.candidates.size(); ++i) {
      const Component& component = m_inquiry.candidates[i];
      const auto isThere = [&](const Explanation& other) { return other.has(i); };
      if (!component.isKnown() || std::ranges::any_of(all, isThere)) continue;
      Part part;
      part.component = i;
      part.weights = Eigen::VectorXd::Zero(component.weights());
      const auto evidence = m_weighed.logEvidenceOf(m_whole, part);
      if (!evidence) continue;
      const double chance = staleChanceOf(*m_inquiry.base.measurement,
                                          *effectById(component.id(), *m_inquiry.base.measurement));
      Explanation stale = m_whole;
      stale.parts.insert(stale.parts.begin(), part);
      stale.logPosteriorOdds += *evidence + std::log(chance / (1 - chance));
      all.push_back(std::move(stale));
    }
  }
};

}  // namespace

std::optional<MeasuredWithEffects> measuredIntersection(const Inquiry& inquiry, const Answer& answer) {
  if (!hasBothAxes(*inquiry.base.measurement)) return std::nullopt;
  return Measured(inquiry, answer).measured();
}

}  // namespace alidade
