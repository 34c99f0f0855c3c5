#include "core/diagnosis/conclusion/afterwards.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "core/base/normal_mixture.h"
#include "core/base/random_source.h"
#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/search/explained_model.h"
#include "core/effects/known_sizes.h"

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

/// What a pattern moves the Δd of a model by; zeros that the model does not sight move nothing.
double movedBy(const GapModel& model, const Inquiry& inquiry, const Part& pattern) {
  using Place = std::tuple<std::size_t, std::size_t, ReadingKind>;
  const Eigen::VectorXd influence = influencePerSigma(model),
                        along = inquiry.of(pattern).times(inquiry.leftover, pattern.weights);
  std::map<Place, double> perSigma;
  for (Eigen::Index i = 0; i < influence.size(); ++i) {
    const AdjustedReading& reading = model.fit->readings[static_cast<std::size_t>(i)];
    perSigma[{reading.arc, reading.sighting, reading.kind}] = influence[i];
  }
  double moved = 0;
  for (Eigen::Index i = 0; i < along.size(); ++i) {
    const LinearReading& reading = inquiry.leftover.reading(i);
    if (const auto own = perSigma.find({reading.arc, reading.sighting, reading.kind}); own != perSigma.end())
      moved += own->second * along[i];
  }
  return moved;
}

/// Collects what else may be the case.
class Average {
 public:
  Average(const Inquiry& inquiry, const Answer& answer, const IntersectionEstimate& own, LinearMoves& moves)
      : m_inquiry(inquiry), m_answer(answer), m_own(own), m_moves(moves) {
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

  /// With every effect there besides, it may be that nothing else is: at most as likely as that something is,
  /// since what is out of the ordinary would leave the ordinary little to say.
  void addNothingElse() {
    const auto isAnswer = [&](const Explanation& explanation) {
      return m_answer.pattern ? explanation.shaped : areAlike(explanation, m_answer.explanation);
    };
    const auto own = std::ranges::find_if(m_inquiry.explanations, isAnswer);
    if (own == m_inquiry.explanations.end()) return;
    const Explanation nothing;
    const auto gain = m_moves.logEvidenceOfEffects(*own), ofNothing = m_moves.logEvidenceOfEffects(nothing);
    const auto difference = isLarge(*m_inquiry.base.measurement) ? differenceOf(nothing) : byFit(nothing);
    if (!gain || !ofNothing || !difference) return;
    std::erase_if(m_alternatives, [&](const Alternative& alternative) {
      return alternative.explanation.parts.empty() && !alternative.explanation.noisy && alternative.odds < 1;
    });
    double something = 0;
    for (const Alternative& alternative : m_alternatives) something += alternative.odds;
    const double odds = oddsOf(*ofNothing - *gain - own->logPosteriorOdds);
    m_alternatives.push_back({std::min(odds, something), nothing, *difference, false});
  }

  /// Besides the answer, that what is known of an effect holds no longer, each by itself: as likely as it was
  /// beforehand and as these readings leave it.
  void addStale() {
    if (!m_ofAnswer) return;
    const auto isThere = [&](std::size_t component) {
      return std::ranges::any_of(m_alternatives, [&](const Alternative& alternative) {
        return alternative.explanation.has(component);
      });
    };
    for (std::size_t i = 0; i < m_inquiry.candidates.size(); ++i) {
      const Component& component = m_inquiry.candidates[i];
      if (!component.isKnown() || isThere(i)) continue;
      const auto stale = m_moves.ofStale(m_answer.explanation, i);
      if (!stale) continue;
      const double chance = staleChanceOf(*m_inquiry.base.measurement, *effectById(component.id()));
      m_alternatives.push_back(
          {chance / (1 - chance) * oddsOf(stale->logEvidence),
           m_answer.explanation,
           {stale->move.shift - m_ofAnswer->shift, stale->move.variance - m_ofAnswer->variance}});
    }
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
  LinearMoves& m_moves;
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
    if (m_moves.besides() == Besides::EveryEffect) model = withEveryEffect(std::move(model));
    const std::optional<IntersectionEstimate> other = estimateOf(model);
    if (!other) return std::nullopt;
    return Difference{other->value - m_own.value,
                      other->sigma * other->sigma - m_own.sigma * m_own.sigma + ofPattern * ofPattern};
  }
};

}  // namespace

IntersectionEstimate averaged(const Inquiry& inquiry, const Answer& answer, const IntersectionEstimate& own,
                              LinearMoves& moves) {
  const bool isEveryEffect = moves.besides() == Besides::EveryEffect;
  const bool mayBeStale = isEveryEffect && isAnythingKnown(*inquiry.base.measurement);
  const bool isNothing = answer.kind == Answer::Kind::Nothing;
  if ((isNothing && !mayBeStale) || !(own.sigma > 0)) return own;
  Average average(inquiry, answer, own, moves);
  if (!isNothing) {
    if (!answer.pattern) average.addExplanations();
    average.addRivals();
    if (isEveryEffect) average.addNothingElse();
  }
  if (mayBeStale) average.addStale();
  return average.estimate(answer.pattern ? movedBy(answer.measured, inquiry, *answer.pattern) : 0);
}

std::optional<IntersectionEstimate> modelAveragedIntersection(const Inquiry& inquiry, const Answer& answer) {
  const std::optional<IntersectionEstimate> own = estimateOf(answer.measured);
  if (!own) return own;
  LinearMoves moves(inquiry);
  return averaged(inquiry, answer, *own, moves);
}

}  // namespace alidade
