#include "core/diagnosis/conclusion/afterwards.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "core/base/normal_mixture.h"
#include "core/base/square.h"
#include "core/base/statistics.h"
#include "core/diagnosis/conclusion/linear_move.h"
#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/diagnosis/search/explained_model.h"

namespace alidade {

namespace {

constexpr double leastOdds = 1e-3;  // least odds of a look-alike that counts

struct Alternative {
  Explanation explanation;
  Possible possible;
};

/// The change of a model's Δd by a pattern; zeros that are not readings of the model contribute nothing.
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

/// Averages Δd over the answer and its alternatives.
class Average {
 public:
  Average(const Inquiry& inquiry, const Answer& answer, const IntersectionEstimate& own)
      : m_inquiry(inquiry), m_answer(answer), m_own(own), m_moves(inquiry) {
    m_ofAnswer = m_moves.of(answer.explanation);
    m_alternatives.push_back({answer.explanation, {}});
  }

  void addExplanations() {
    const Explanation* const own = explanationOf(m_inquiry, m_answer);
    if (!own) return;
    for (const Explanation& explanation : m_inquiry.explanations)
      if (explanation.chance >= thresholds.leastAveraged && &explanation != own &&
          isInAverage(explanation, m_answer))
        add(explanation, oddsOf(explanation.logPosteriorOdds - own->logPosteriorOdds));
  }

  void addRivals() {
    for (const Explanation& other : withRivals(m_answer, m_answer.explanation)) {
      const auto isThat = [&](const Alternative& one) { return areAlike(one.explanation, other); };
      if (std::ranges::none_of(m_alternatives, isThat))
        add(other, oddsOf(other.logPosteriorOdds - m_answer.explanation.logPosteriorOdds));
    }
  }

  /// `ofPattern` is the change of Δd by the pattern of the answer, mm.
  IntersectionEstimate estimate(double ofPattern) const {
    std::vector<Possible> all;
    for (const Alternative& alternative : m_alternatives) {
      all.push_back(alternative.possible);
      all.back().variance += square(ofPattern);
    }
    return averagedOver(m_own, all, m_inquiry.base.measurement->coverage);
  }

 private:
  const Inquiry& m_inquiry;
  const Answer& m_answer;
  IntersectionEstimate m_own;
  LinearMoves m_moves;
  std::optional<Move> m_ofAnswer;
  std::vector<Alternative> m_alternatives;  ///< the answer first

  void add(const Explanation& explanation, double odds) {
    std::optional<Possible> possible = byMove(explanation);
    if (!possible) possible = byFit(explanation);
    if (!possible) return;
    possible->odds = odds;
    m_alternatives.push_back({explanation, *possible});
  }

  std::optional<Possible> byMove(const Explanation& explanation) {
    if (!m_ofAnswer) return std::nullopt;
    const std::optional<Move> move = m_moves.of(explanation);
    if (!move) return std::nullopt;
    return Possible{1, move->shift - m_ofAnswer->shift, move->variance - m_ofAnswer->variance};
  }

  /// Evaluates a nonlinear explanation by a fit. A pattern does not shift Δd but adds to its variance. Absent
  /// if the readings do not determine Δd.
  std::optional<Possible> byFit(Explanation explanation) const {
    double ofPattern = 0;
    if (explanation.shaped) {
      ofPattern = movedBy(m_inquiry.base, m_inquiry, explanation.parts.back());
      explanation.parts.pop_back();
    }
    const std::optional<IntersectionEstimate> other =
        estimateOf(modelWith(m_inquiry.base, explanation, m_inquiry.candidates, m_inquiry.leftover));
    if (!other) return std::nullopt;
    return Possible{1, other->value - m_own.value,
                    square(other->sigma) - square(m_own.sigma) + square(ofPattern)};
  }
};

}  // namespace

IntersectionEstimate averagedOver(const IntersectionEstimate& own, const std::vector<Possible>& all,
                                  double coverage) {
  constexpr double hardly = 0.01;         // share of U; a smaller change is ignored
  constexpr double leastVariance = 1e-6;  // share of the own variance; a limit against rounding errors
  const double factor = own.expanded / own.sigma, wider = factor / normalQuantile((1 + coverage) / 2);
  std::vector<NormalPart> mixture;
  for (const Possible& possible : all) {
    const double variance = square(own.sigma) + possible.variance;
    mixture.push_back(
        {possible.odds, possible.value, std::sqrt(std::max(variance, leastVariance * square(own.sigma)))});
  }
  constexpr double grain = 0.05;  // closer parts are joined; distance in σ
  const auto [mean, sigma] = momentsOf(mixture);
  mixture = joined(mixture, grain * sigma);
  std::vector<NormalPart> explanations = mixture;
  for (NormalPart& explanation : explanations) explanation.mean += own.value;
  for (NormalPart& part : mixture) part.sigma *= wider;
  const double expanded = std::max(factor * sigma, halfWidth(mixture, mean, coverage));
  if (std::abs(mean) + std::abs(expanded - own.expanded) < hardly * own.expanded) return own;
  return {own.value + mean, sigma, expanded, std::move(explanations), own.degreesOfFreedom};
}

IntersectionEstimate widerBy(IntersectionEstimate own, double variance) {
  const double sigma = std::sqrt(square(own.sigma) + std::max(variance, 0.0));
  own.expanded *= sigma / own.sigma;
  own.sigma = sigma;
  own.explanations = {{1, own.value, own.sigma}};
  return own;
}

std::vector<Explanation> withRivals(const Answer& answer, const Explanation& explanation) {
  std::vector<Explanation> all{explanation};
  for (std::size_t p = 0; p < answer.rivals.size(); ++p) {
    const std::size_t component = answer.explanation.parts[p].component, count = all.size();
    for (const Rival& rival : answer.rivals[p])
      for (std::size_t i = 0; i < count && rival.odds >= leastOdds; ++i) {
        if (all[i].has(rival.part.component)) continue;
        Explanation next = all[i];
        const auto place = std::ranges::find(next.parts, component, &Part::component);
        if (place == next.parts.end()) continue;
        *place = rival.part;
        next.logPosteriorOdds += std::log(rival.odds);
        all.push_back(std::move(next));
      }
  }
  return all;
}

const Explanation* explanationOf(const Inquiry& inquiry, const Answer& answer) {
  const auto found = std::ranges::find_if(inquiry.explanations, [&](const Explanation& explanation) {
    return answer.pattern ? explanation.shaped : areAlike(explanation, answer.explanation);
  });
  return found == inquiry.explanations.end() ? nullptr : &*found;
}

bool isInAverage(const Explanation& explanation, const Answer& answer) {
  const bool isInTheNoise = answer.explanation.noisy && isPartOf(answer.explanation, explanation);
  return !isInTheNoise && std::ranges::all_of(explanation.parts, &Part::isSupported);
}

std::optional<IntersectionEstimate> modelAveragedIntersection(const Inquiry& inquiry, const Answer& answer) {
  const std::optional<IntersectionEstimate> own = estimateOf(answer.measured);
  if (!own || answer.kind == Answer::Kind::Nothing || answer.kind == Answer::Kind::Several ||
      !(own->sigma > 0))
    return own;
  Average average(inquiry, answer, *own);
  if (!answer.pattern) average.addExplanations();
  average.addRivals();
  return average.estimate(answer.pattern ? movedBy(answer.measured, inquiry, *answer.pattern) : 0);
}

}  // namespace alidade
