#include "core/diagnosis/conclusion/afterwards.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/adjustment/result/intersection.h"
#include "core/base/normal_mixture.h"
#include "core/base/random_source.h"
#include "core/diagnosis/conclusion/linear_move.h"
#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/search/explained_model.h"
#include "core/effects/catalogue.h"

namespace alidade {

namespace {

/// Δd if an explanation is the right one, counted from that of the answer.
struct Difference {
  double value = 0, variance = 0;
};

struct Alternative {
  double odds = 1;  ///< against the answer
  Explanation explanation;
  Difference difference;
  bool hasPattern = true;  ///< where the answer has one
};

/// The readings speak for each of its parts: what only might be there besides is unseen, and told apart.
bool isSupported(const Explanation& explanation) {
  return std::ranges::all_of(explanation.parts, &Part::isSupported);
}

/// Under larger noise, what may be there besides is what that noise stands for.
bool isInTheNoise(const Explanation& explanation, const Explanation& answer) {
  return answer.noisy && isPartOf(answer, explanation);
}

/// What a pattern moves the Δd of a model by.
double movedBy(const GapModel& model, const Inquiry& inquiry, const Part& pattern) {
  return influencePerSigma(model).dot(inquiry.of(pattern).times(inquiry.leftover, pattern.weights));
}

/// Collects what else may be the case.
class Average {
 public:
  Average(const Inquiry& inquiry, const Answer& answer, const IntersectionEstimate& own, Besides besides)
      : m_inquiry(inquiry), m_answer(answer), m_own(own), m_besides(besides), m_moves(inquiry, besides) {
    m_ofAnswer = m_moves.of(answer.explanation);
    m_alternatives.push_back({1, answer.explanation, {}});
  }

  void addExplanations() {
    const auto own = std::ranges::find_if(m_inquiry.explanations, [&](const Explanation& explanation) {
      return areAlike(explanation, m_answer.explanation);
    });
    if (own == m_inquiry.explanations.end()) return;
    for (const Explanation& explanation : m_inquiry.explanations) {
      const double odds = oddsOf(explanation.logPosteriorOdds - own->logPosteriorOdds);
      if (explanation.chance < leastChance || &explanation == &*own || !isSupported(explanation) ||
          isInTheNoise(explanation, m_answer.explanation))
        continue;
      if (const std::optional<Difference> difference = differenceOf(explanation))
        m_alternatives.push_back({odds, explanation, *difference});
    }
  }

  /// In place of each part, whatever stands in the places of the others.
  void addRivals() {
    const std::size_t found = m_alternatives.size();
    std::vector<Alternative> combined{m_alternatives.front()};
    for (std::size_t p = 0; p < m_answer.rivals.size(); ++p) {
      const std::size_t count = combined.size();
      for (const Rival& rival : m_answer.rivals[p]) {
        if (rival.odds < leastOdds) continue;
        Explanation inPlace = m_answer.explanation;
        inPlace.parts[p] = rival.part;
        const std::optional<Difference> difference = differenceOf(inPlace);
        if (!difference) continue;
        for (std::size_t i = 0; i < count; ++i) {
          Alternative next = combined[i];
          if (next.explanation.has(rival.part.component)) continue;
          next.odds *= rival.odds;
          next.explanation.parts[p] = rival.part;
          next.difference.value += difference->value;
          next.difference.variance += difference->variance;
          combined.push_back(std::move(next));
        }
      }
    }
    for (Alternative& alternative : combined) {
      const auto isThat = [&](const Alternative& other) {
        return areAlike(other.explanation, alternative.explanation);
      };
      const auto before = m_alternatives.begin() + static_cast<std::ptrdiff_t>(found);
      if (std::find_if(m_alternatives.begin(), before, isThat) == before)
        m_alternatives.push_back(std::move(alternative));
    }
  }

  /// With every effect there besides, less is left to be explained: weighs again what was found, and adds
  /// that nothing else is there.
  void weighBesideEffects() {
    const auto isAnswer = [&](const Explanation& explanation) {
      return m_answer.pattern ? explanation.shaped : areAlike(explanation, m_answer.explanation);
    };
    const auto own = std::ranges::find_if(m_inquiry.explanations, isAnswer);
    const auto gain = own == m_inquiry.explanations.end() ? std::nullopt : m_moves.logEvidenceOfEffects(*own);
    if (!gain) return;
    for (Alternative& alternative : m_alternatives) {
      Explanation with = alternative.explanation;
      if (m_answer.pattern) with.parts.push_back(*m_answer.pattern);
      if (&alternative == &m_alternatives.front()) continue;
      if (const auto other = m_moves.logEvidenceOfEffects(with)) alternative.odds *= oddsOf(*other - *gain);
    }
    const Explanation nothing;
    std::erase_if(m_alternatives, [&](const Alternative& alternative) {
      return areAlike(alternative.explanation, nothing) && &alternative != &m_alternatives.front();
    });
    const auto ofNothing = m_moves.logEvidenceOfEffects(nothing);
    const auto difference = byFit(nothing);
    if (ofNothing && difference)
      m_alternatives.push_back(
          {oddsOf(*ofNothing - *gain - own->logPosteriorOdds), nothing, *difference, false});
  }

  IntersectionEstimate estimate(double ofPattern) const {
    constexpr double hardly = 0.01;  // of U
    const double coverage = m_inquiry.base.measurement->coverage;
    const double factor = m_own.expanded / m_own.sigma, wider = factor / normalQuantile((1 + coverage) / 2);
    const double square = m_own.sigma * m_own.sigma;
    std::vector<NormalPart> mixture;
    for (const Alternative& alternative : m_alternatives) {
      const double variance = std::max(square + alternative.difference.variance, leastVariance * square);
      mixture.push_back(
          {alternative.odds, alternative.difference.value,
           alternative.hasPattern ? std::hypot(std::sqrt(variance), ofPattern) : std::sqrt(variance)});
    }
    const auto [mean, sigma] = momentsOf(mixture);
    std::vector<NormalPart> accounts = mixture;
    for (NormalPart& account : accounts) account.mean += m_own.value;
    for (NormalPart& part : mixture) part.sigma *= wider;
    const double expanded = std::max(factor * sigma, halfWidth(mixture, mean, coverage));
    if (std::abs(mean) + std::abs(expanded - m_own.expanded) < hardly * m_own.expanded) return m_own;
    return {m_own.value + mean, sigma, expanded, std::move(accounts), m_own.degreesOfFreedom};
  }

 private:
  static constexpr double leastChance = 0.01, leastOdds = 1e-3;
  static constexpr double leastVariance = 1e-6;  ///< of the answer's: of rounding
  const Inquiry& m_inquiry;
  const Answer& m_answer;
  IntersectionEstimate m_own;
  Besides m_besides;
  LinearMoves m_moves;
  std::optional<Move> m_ofAnswer;
  std::vector<Alternative> m_alternatives;  ///< the answer first

  std::optional<Difference> differenceOf(const Explanation& explanation) {
    if (m_ofAnswer)
      if (const std::optional<Move> move = m_moves.of(explanation))
        return Difference{move->shift - m_ofAnswer->shift, move->variance - m_ofAnswer->variance};
    return byFit(explanation);
  }

  /// Of what bends: a pattern does not shift Δd. Absent where the readings do not determine it.
  std::optional<Difference> byFit(Explanation explanation) const {
    double ofPattern = 0;
    if (explanation.shaped) {
      ofPattern = movedBy(m_inquiry.base, m_inquiry, explanation.parts.back());
      explanation.parts.pop_back();
    }
    GapModel model = modelWith(m_inquiry.base, explanation, m_inquiry.candidates, m_inquiry.leftover);
    if (m_besides == Besides::EveryEffect) model = withEveryEffect(std::move(model));
    const std::optional<IntersectionEstimate> other = estimateOf(model);
    if (!other) return std::nullopt;
    return Difference{other->value - m_own.value,
                      other->sigma * other->sigma - m_own.sigma * m_own.sigma + ofPattern * ofPattern};
  }
};

IntersectionEstimate averaged(const Inquiry& inquiry, const Answer& answer, const IntersectionEstimate& own,
                              Besides besides) {
  if (answer.kind == Answer::Kind::Nothing || !(own.sigma > 0)) return own;
  Average average(inquiry, answer, own, besides);
  if (!answer.pattern) average.addExplanations();
  average.addRivals();
  if (besides == Besides::EveryEffect) average.weighBesideEffects();
  return average.estimate(answer.pattern ? movedBy(answer.measured, inquiry, *answer.pattern) : 0);
}

/// What each part of the catalogue brings to the variance of Δd, that of the readings left aside.
std::vector<UncertaintyShare> sharesOfEffects(const GapModel& model) {
  const JointFit& fit = *model.fit;
  const std::vector<double> weights =
      intersectionWeights(fit, arcAt(*model.measurement, 0).value(), arcAt(*model.measurement, 180).value());
  std::vector<UncertaintyShare> shares;
  for (const Effect& effect : effectCatalogue()) {
    UncertaintyShare share{.effect = std::string(effect.id), .from = UncertaintyShare::From::Default};
    for (const EffectParameter& parameter : effect.parameters) {
      const std::size_t index = fit.indexOf({.kind = Unknown::Kind::Error, .arc = 0, .term = parameter.term});
      if (index == fit.unknowns.size()) continue;
      if (fit.priorSigmas[index] > plausibleSize(parameter)) share.from = UncertaintyShare::From::Diagnosis;
      double gain = 0;
      for (std::size_t i = 0; i < weights.size(); ++i) gain += weights[i] * fit.cofactor(i, index);
      share.sigma = std::hypot(share.sigma, gain / fit.priorSigmas[index]);
      share.sizes.push_back({std::string(parameter.name),
                             fit.priorSigmas[index] / modelUnitsPer(parameter.unit),
                             std::string(parameter.unit)});
    }
    if (!share.sizes.empty()) shares.push_back(std::move(share));
  }
  return shares;
}

std::vector<UncertaintyShare> budgetOf(const GapModel& model, const IntersectionEstimate& averaged) {
  const Intersection own = *intersect(*model.measurement, *model.fit);
  std::vector<UncertaintyShare> shares = sharesOfEffects(model);
  double ofReadings = 0;
  for (const BudgetEntry& entry : own.budget) {
    if (entry.source == UncertaintySource::PlausibleSizes) continue;
    if (entry.source == UncertaintySource::Readings || entry.source == UncertaintySource::ModelEffects)
      ofReadings = std::hypot(ofReadings, entry.sigma);
    else
      shares.push_back({.source = entry.source, .sigma = entry.sigma});
  }
  using enum UncertaintyShare::From;
  const double degreesOfFreedom = noiseScale(*model.fit).degreesOfFreedom;
  shares.push_back({.source = UncertaintySource::Readings,
                    .type = UncertaintyShare::Type::A,
                    .from = std::isfinite(degreesOfFreedom) ? Scatter : Stated,
                    .sigma = ofReadings,
                    .degreesOfFreedom = degreesOfFreedom});
  const double beyond = averaged.sigma * averaged.sigma - own.sigma * own.sigma;
  if (beyond > 0) shares.push_back({.from = UncertaintyShare::From::Diagnosis, .sigma = std::sqrt(beyond)});
  std::ranges::stable_sort(shares, std::greater(), &UncertaintyShare::sigma);
  return shares;
}

}  // namespace

std::optional<MeasuredIntersection> measuredIntersection(const Inquiry& inquiry, const Answer& answer) {
  const GapModel model = withEveryEffect(answer.after);
  const std::optional<IntersectionEstimate> own = estimateOf(model);
  if (!own) return std::nullopt;
  const IntersectionEstimate estimate = averaged(inquiry, answer, *own, Besides::EveryEffect);
  return MeasuredIntersection{estimate, budgetOf(model, estimate)};
}

std::optional<IntersectionEstimate> modelAveragedIntersection(const Inquiry& inquiry, const Answer& answer) {
  const std::optional<IntersectionEstimate> own = estimateOf(answer.measured);
  if (!own) return own;
  return averaged(inquiry, answer, *own, Besides::Nothing);
}

}  // namespace alidade
