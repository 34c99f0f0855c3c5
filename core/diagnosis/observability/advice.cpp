#include "core/diagnosis/observability/advice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "core/diagnosis/candidates/jump_components.h"
#include "core/diagnosis/observability/further_terms.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/effects/cause_ids.h"
#include "core/observation/observe.h"
#include "core/observation/reading_ref.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Distances between identifiers, σ: the smallest of all pairs of suspects with these identifiers.
class Distances {
 public:
  template <typename Apart>
  Distances(const std::vector<PossibleCause>& suspects, const Apart& apart) {
    for (const PossibleCause& suspect : suspects) {
      if (indexOf(suspect.id) == m_ids.size()) {
        m_ids.push_back(suspect.id);
        m_odds.push_back(0);
      }
      m_odds[indexOf(suspect.id)] += suspect.odds;
    }
    const auto count = static_cast<Index>(m_ids.size());
    m_apart = MatrixXd::Constant(count, count, std::numeric_limits<double>::infinity());
    for (const PossibleCause& one : suspects)
      for (const PossibleCause& other : suspects) {
        if (one.id == other.id) continue;
        const auto i = static_cast<Index>(indexOf(one.id)), j = static_cast<Index>(indexOf(other.id));
        m_apart(i, j) = m_apart(j, i) = std::min(m_apart(i, j), apart(one, other));
      }
  }

  /// Returns the largest set of suspects that are pairwise apart; among sets of equal size, the most likely.
  Advice largestApart(std::vector<Measure> measures) const {
    Advice advice{.measures = std::move(measures)};
    double most = 0;
    for (std::uint64_t set = 1; set < (std::uint64_t{1} << m_ids.size()); ++set) {
      double least = std::numeric_limits<double>::infinity(), odds = 0;
      std::vector<std::string> ids;
      for (std::size_t i = 0; i < m_ids.size(); ++i) {
        if (!(set >> i & 1)) continue;
        ids.push_back(m_ids[i]);
        odds += m_odds[i];
        for (std::size_t j = 0; j < i; ++j)
          if (set >> j & 1) least = std::min(least, m_apart(static_cast<Index>(i), static_cast<Index>(j)));
      }
      if (ids.size() < 2 || least < thresholds.clearlyDifferent) continue;
      const bool isBetter = std::pair(ids.size(), odds) > std::pair(advice.separates.size(), most);
      if (!isBetter) continue;
      most = odds;
      advice.separates = std::move(ids);
      advice.bySigma = least;
    }
    advice.oneLeft = oneLeft();
    return advice;
  }

 private:
  std::vector<std::string> m_ids;
  std::vector<double> m_odds;
  MatrixXd m_apart;  ///< σ; infinite on the diagonal

  std::size_t indexOf(const std::string& id) const {
    return static_cast<std::size_t>(std::ranges::find(m_ids, id) - m_ids.begin());
  }

  /// Probability that each suspect is distinguished from all others, averaged with the odds. A suspect at a
  /// distance of d σ is clearly distinguished with the probability 2 Φ(d/2) − 1.
  double oneLeft() const {
    double sum = 0, all = 0;
    for (std::size_t i = 0; i < m_ids.size(); ++i) {
      double chance = m_odds[i];
      for (std::size_t j = 0; j < m_ids.size(); ++j)
        if (i != j)
          chance *= std::erf(m_apart(static_cast<Index>(i), static_cast<Index>(j)) / 2 / std::numbers::sqrt2);
      sum += chance;
      all += m_odds[i];
    }
    return all > 0 ? sum / all : 0;
  }
};

/// Returns the columns of a suspect as combinations of `terms`, scaled to plausible sizes. `moments` are
/// those of the jumps that follow the terms. Absent for a jump at another moment.
std::optional<MatrixXd> columnsOf(const PossibleCause& suspect, const Effect* effect,
                                  const VisibleTerms& terms, const std::vector<JumpMoment>& moments) {
  const Index size = terms.gram.rows();
  if (effect) {
    const MatrixXd ofTerms = combinationOf(*effect);
    MatrixXd columns = MatrixXd::Zero(size, ofTerms.cols());
    columns.topRows(ofTerms.rows()) = ofTerms;
    return columns;
  }
  const auto own = std::ranges::find(moments, suspect.moment);
  const auto first = static_cast<Index>(errorTermCount) + 2 * (own - moments.begin());
  if (own == moments.end() || first >= size) return std::nullopt;
  MatrixXd columns = MatrixXd::Zero(size, 2);
  columns.middleRows<2>(first) = plausibleJump * Eigen::Matrix2d::Identity();
  return columns;
}

/// Returns the distance of two suspects in further readings, from the visible terms and jumps.
double apartBy(const VisibleTerms& terms, const std::vector<JumpMoment>& moments,
               const Measurement& measurement, const PossibleCause& one, const PossibleCause& other) {
  const Effect* effect = effectById(other.id, measurement);
  const auto first = columnsOf(one, effectById(one.id, measurement), terms, moments),
             second = columnsOf(other, effect, terms, moments);
  if (!first || !second) return 0;
  return linearDifferenceFrom(terms, *first * one.weights, *second,
                              effect ? effect->response : Response::Linear);
}

/// σ of the difference of two sightings of a zero, rad: horizontal, then vertical.
Eigen::Vector2d sigmasOfTwoSightings(const Measurement& measurement) {
  return std::numbers::sqrt2 * Eigen::Vector2d(statedSigma(measurement, ReadingKind::Horizontal).radians(),
                                               statedSigma(measurement, ReadingKind::Vertical).radians());
}

/// Returns the effect of a suspect on a new sighting of the zero after the last visit of each position. The
/// result is for both circles, in σ of the difference of two sightings. It is the rate of a drift times the
/// time since the first sighting, the size of a jump, and 0 for a guideway effect.
VectorXd atTheZeros(const Measurement& measurement, const PossibleCause& suspect) {
  VectorXd left = VectorXd::Zero(2 * std::ssize(measurement.arcs));
  const Eigen::Vector2d sigmas = sigmasOfTwoSightings(measurement);
  const Effect* effect = effectById(suspect.id, measurement);
  for (std::size_t arc = 0; arc < measurement.arcs.size(); ++arc) {
    Eigen::Vector2d moved = Eigen::Vector2d::Zero();
    if (suspect.arc == arc) moved = suspect.weights * plausibleJump;
    if (effect && !measurement.arcs[arc].sightings.empty()) {
      const double since =
          std::ranges::max(measurement.arcs[arc].sightings, {}, &Sighting::sequence).elapsed -
          measurement.arcs[arc].zero.elapsed;
      for (std::size_t p = 0; p < effect->parameters.size(); ++p) {
        const double size =
            suspect.weights[static_cast<Index>(p)] * plausibleSize(effect->parameters[p]) * since;
        if (effect->parameters[p].traits.turnsHorizontalZero) moved[0] += size;
        if (effect->parameters[p].traits.turnsVerticalZero) moved[1] += size;
      }
    }
    left.segment<2>(2 * static_cast<Index>(arc)) = moved.cwiseQuotient(sigmas);
  }
  return left;
}

/// Errors of the instrument's axes and circles are equal in both sightings of a zero: they cancel.
Advice bySightingZeros(const Measurement& measurement, const std::vector<PossibleCause>& suspects) {
  return Distances(suspects,
                   [&](const PossibleCause& one, const PossibleCause& other) {
                     return (atTheZeros(measurement, one) - atTheZeros(measurement, other)).norm();
                   })
      .largestApart({Measure::ZeroSightedAgain});
}

/// Returns the effect of a suspect on the difference of two measured distances, in σ of this difference. The
/// σ of one distance is the stated σ, or 1 mm if none is stated.
double atTheDistances(const Measurement& measurement, const PossibleCause& suspect) {
  constexpr double usualSigma = 1;  // mm
  const double sigma = measurement.sigmaDistance > 0 ? measurement.sigmaDistance : usualSigma;
  const Effect* effect = effectById(suspect.id, measurement);
  if (!effect || !effect->parameters.front().traits.changesDistance) return 0;
  return 2 * suspect.weights[0] * plausibleSize(effect->parameters.front()) / (sigma * std::numbers::sqrt2);
}

Advice byMeasuringDistances(const Measurement& measurement, const std::vector<PossibleCause>& suspects) {
  return Distances(suspects,
                   [&](const PossibleCause& one, const PossibleCause& other) {
                     return std::abs(atTheDistances(measurement, one) - atTheDistances(measurement, other));
                   })
      .largestApart({Measure::DistanceInBoth});
}

/// Sorts by the probability that one answer remains, rounded to a twentieth; then by effort.
void rank(std::vector<Advice>& list) {
  const auto twentieths = [](const Advice& advice) { return std::lround(20 * advice.oneLeft); };
  std::ranges::stable_sort(list, [&](const Advice& a, const Advice& b) {
    if (twentieths(a) != twentieths(b)) return twentieths(a) > twentieths(b);
    return effortOf(a.measures) < effortOf(b.measures);
  });
}

/// Keeps at most one combination: the best, if it leaves one answer more often than every single measure.
/// Among equally good combinations it is the cheapest.
void keepUsefulCombinations(std::vector<Advice>& list) {
  constexpr double notable = 0.05;
  double single = 0;
  for (const Advice& advice : list)
    if (advice.measures.size() == 1) single = std::max(single, advice.oneLeft);
  rank(list);
  bool isTaken = false;
  std::erase_if(list, [&](const Advice& advice) {
    if (advice.measures.size() == 1) return false;
    const bool isUseful = !isTaken && advice.oneLeft > single + notable;
    isTaken = isTaken || isUseful;
    return !isUseful;
  });
}

std::optional<Advice> revealing(const std::vector<Detectability>& undetectable, std::vector<Measure> measures,
                                const VisibleTerms& terms, const Measurement& measurement) {
  Advice advice{.measures = std::move(measures), .ofUndetectable = true};
  for (const Detectability& detectability : undetectable) {
    const Effect* effect = effectById(detectability.effect, measurement);
    if (!effect) continue;
    const double visible = lengthOf(terms, combinationOf(*effect) * detectability.weights);
    if (visible < thresholds.clearlyDifferent) continue;
    advice.bySigma = advice.separates.empty() ? visible : std::min(advice.bySigma, visible);
    advice.separates.emplace_back(detectability.effect);
  }
  if (advice.separates.empty()) return std::nullopt;
  return advice;
}

/// Returns the advice to sight the zero again if a gross error looks like a jump: only a jump moves the zero.
/// Both sightings of the zero have noise.
std::optional<Advice> separatingFromJump(const Inquiry& inquiry, const std::vector<Cause>& causes) {
  for (const Cause& cause : causes) {
    if (cause.readings.size() != 1 || cause.indistinguishableFrom.empty()) continue;
    const ReadingDeviation& reading = cause.readings.front();
    const double sigma = statedSigma(*inquiry.base.measurement, reading.kind).arcseconds();
    return Advice{.measures = {Measure::ZeroSightedAgain},
                  .separates = {cause.effect, cause.indistinguishableFrom.front()},
                  .bySigma = std::abs(reading.size) / (sigma * std::numbers::sqrt2)};
  }
  return std::nullopt;
}

/// Returns the advice to sight the zero again if a jump is undetectable: the zero reveals the jump.
std::optional<Advice> revealingJump(const Inquiry& inquiry, const std::vector<Detectability>& undetectable) {
  const auto jump = std::ranges::find(undetectable, jumpId, &Detectability::effect);
  if (jump == undetectable.end()) return std::nullopt;
  const Eigen::Vector2d sigmas = sigmasOfTwoSightings(*inquiry.base.measurement);
  return Advice{.measures = {Measure::ZeroSightedAgain},
                .separates = {jumpId},
                .bySigma = (plausibleJump * jump->weights).cwiseQuotient(sigmas).norm(),
                .ofUndetectable = true};
}

/// Returns the effects of the catalogue whose identifiers are in the list.
template <typename List, typename Id>
std::vector<const Effect*> effectsIn(const List& list, const Id& id, const Measurement& measurement) {
  std::vector<const Effect*> effects;
  for (const auto& entry : list)
    if (const Effect* effect = effectById(std::invoke(id, entry), measurement)) effects.push_back(effect);
  return effects;
}

/// Returns advice on readings that separate suspects.
std::vector<Advice> separating(const Inquiry& inquiry, const std::vector<PossibleCause>& suspects) {
  std::vector<Advice> list;
  const auto offer = [&](Advice advice) {
    if (advice.separates.size() > 1) list.push_back(std::move(advice));
  };
  std::vector<JumpMoment> moments;
  for (const PossibleCause& suspect : suspects)
    if (suspect.moment) moments.push_back(*suspect.moment);
  FurtherTerms further(inquiry.base, inquiry.leftover.equations(),
                       effectsIn(suspects, &PossibleCause::id, *inquiry.base.measurement), moments);
  const auto tryOut = [&](const FurtherReadings& plan) {
    const VisibleTerms terms = further.shownBy(plan);
    const Distances distances(suspects, [&](const PossibleCause& one, const PossibleCause& other) {
      return apartBy(terms, moments, *inquiry.base.measurement, one, other);
    });
    offer(distances.largestApart(plan.measures));
  };
  eachFurtherReadings(inquiry.base, tryOut);
  offer(bySightingZeros(*inquiry.base.measurement, suspects));
  offer(byMeasuringDistances(*inquiry.base.measurement, suspects));
  const auto isSure = [](const Advice& advice) { return advice.oneLeft > thresholds.certain; };
  if (std::ranges::none_of(list, isSure)) eachCombination(inquiry.base, tryOut);
  keepUsefulCombinations(list);
  return list;
}

/// Returns advice on readings that reveal undetectable effects, the most effective first.
std::vector<Advice> revealing(const Inquiry& inquiry, const std::vector<Detectability>& undetectable) {
  const std::vector<const Effect*> effects =
      effectsIn(undetectable, &Detectability::effect, *inquiry.base.measurement);
  std::vector<Advice> list;
  if (effects.empty()) return list;
  FurtherTerms further(inquiry.base, inquiry.leftover.equations(), effects);
  eachFurtherReadings(inquiry.base, [&](const FurtherReadings& plan) {
    if (const auto advice =
            revealing(undetectable, plan.measures, further.shownBy(plan), *inquiry.base.measurement))
      list.push_back(*advice);
  });
  std::ranges::sort(list, [](const Advice& a, const Advice& b) {
    return std::pair(a.separates.size(), a.bySigma) > std::pair(b.separates.size(), b.bySigma);
  });
  return list;
}

}  // namespace

std::vector<Advice> adviceFor(const Inquiry& inquiry, const std::vector<PossibleCause>& suspects,
                              const std::vector<Cause>& causes,
                              const std::vector<Detectability>& undetectable) {
  constexpr std::size_t most = 16;  // suspects; every subset of them is examined
  const bool isUnclear = suspects.size() > 1 && suspects.size() <= most;
  std::vector<Advice> list = isUnclear ? separating(inquiry, suspects) : revealing(inquiry, undetectable);
  const auto isZero = [](const Advice& advice) {
    return advice.measures == std::vector{Measure::ZeroSightedAgain};
  };
  if (const std::optional<Advice> zero = separatingFromJump(inquiry, causes)) {
    list.insert(list.begin(), *zero);
  } else if (const std::optional<Advice> jump = revealingJump(inquiry, undetectable);
             jump && std::ranges::none_of(list, isZero)) {
    list.insert(isUnclear ? list.end() : list.begin(), *jump);
  }
  return list;
}

}  // namespace alidade
