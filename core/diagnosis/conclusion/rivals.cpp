#include "core/diagnosis/conclusion/rivals.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/observability/look_alikes.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/diagnosis/search/search.h"

namespace alidade {

namespace {

/// Compares other components in the place of a part of an explanation.
class Comparison {
 public:
  Comparison(const Inquiry& inquiry, const Explanation& explanation)
      : m_inquiry(inquiry), m_explanation(explanation), m_own(explanation.parts.size()) {}

  Rival with(std::size_t part, std::size_t component) {
    std::optional<Explanation>& own = m_own[part];
    if (!own) own = made(part, m_explanation.parts[part].component);
    const Explanation found = made(part, component);
    return {oddsOf(found.logPosteriorOdds - own->logPosteriorOdds), found.parts.back()};
  }

 private:
  const Inquiry& m_inquiry;
  const Explanation& m_explanation;
  const SearchOptions m_options;
  std::optional<Search> m_search;  ///< created on first use
  std::vector<std::optional<Explanation>> m_own;

  /// Puts the component last, so that it is added to all other parts.
  Explanation made(std::size_t part, std::size_t component) {
    if (!m_search) m_search.emplace(m_inquiry.leftover, m_inquiry.candidates, m_options);
    std::vector<std::size_t> components;
    for (std::size_t i = 0; i < m_explanation.parts.size(); ++i)
      if (i != part) components.push_back(m_explanation.parts[i].component);
    components.push_back(component);
    return m_search->madeOf(components, m_explanation.noisy ? m_explanation.noise * m_explanation.noise : 1);
  }
};

/// Whether the odds against the rival are at most 33.
bool isClose(const Rival& rival) {
  return rival.odds > 0.03;
}

/// The jumps that only the row of the gross error in part `index` shows, and that are nearly as likely.
std::vector<Rival> jumps(const Inquiry& inquiry, const Explanation& explanation, std::size_t index,
                         Comparison& comparison) {
  const auto isJump = [&](const Part& other) { return inquiry.of(other).isJump(); };
  if (std::ranges::any_of(explanation.parts, isJump)) return {};  // an explanation contains at most one jump
  const Eigen::Index reading = *inquiry.of(explanation.parts[index]).grossErrorAt();
  const std::size_t row = inquiry.leftover.reading(reading).sequence;
  std::vector<Rival> rivals;
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    if (inquiry.candidates[i].onlyRow() != row) continue;
    Rival rival = comparison.with(index, i);
    rival.odds /= 2;  // either circle of the row may be the one that was misread
    if (isClose(rival)) rivals.push_back(std::move(rival));
  }
  return rivals;
}

/// Candidates of the wanted kind that look like the part and that the readings support in its place.
template <typename Kind>
std::vector<Rival> nearlyLike(const Inquiry& inquiry, const Explanation& explanation, std::size_t index,
                              Comparison& comparison, const Kind& isOfKind) {
  const Part& part = explanation.parts[index];
  const Trace trace(inquiry.leftover, inquiry.of(part).signature(inquiry.leftover, part.weights));
  std::vector<Rival> rivals;
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    const auto isOther = [&](const Part& any) { return any.component != i; };
    const Component& candidate = inquiry.candidates[i];
    if (!isOfKind(candidate) || !std::ranges::all_of(explanation.parts, isOther)) continue;
    const double difference = trace.differenceFrom(candidate) / explanation.noise;
    if (difference > thresholds.clearlyDifferent) continue;
    Rival rival = comparison.with(index, i);
    const bool isNear = difference < thresholds.hardlyDifferent;
    rival.isExcluded = candidate.isKnown() && !isClose(rival);
    if (rival.part.isSupported() && (isNear || isClose(rival))) rivals.push_back(std::move(rival));
  }
  return rivals;
}

/// The effects and the jumps between a zero and the first visit that look like the part.
std::vector<Rival> others(const Inquiry& inquiry, const Explanation& explanation, std::size_t index,
                          Comparison& comparison) {
  const auto isJump = [&](const Part& other) { return inquiry.of(other).isJump(); };
  const bool hasJump = std::ranges::any_of(explanation.parts, isJump);  // explanations have at most one jump
  return nearlyLike(inquiry, explanation, index, comparison, [&](const Component& candidate) {
    return candidate.isEffect() || (candidate.wrongZeroArc() && !hasJump);
  });
}

}  // namespace

std::vector<Rival> otherWrongZeros(const Inquiry& inquiry, const Explanation& explanation, std::size_t part) {
  if (!inquiry.of(explanation.parts[part]).isJump()) return {};
  Comparison comparison(inquiry, explanation);
  return nearlyLike(inquiry, explanation, part, comparison,
                    [](const Component& candidate) { return candidate.wrongZeroArc().has_value(); });
}

std::vector<std::vector<Rival>> rivalsOf(const Inquiry& inquiry, const Explanation& explanation) {
  std::vector<std::vector<Rival>> rivals(explanation.parts.size());
  Comparison comparison(inquiry, explanation);
  for (std::size_t p = 0; p < rivals.size(); ++p) {
    const Component& component = inquiry.of(explanation.parts[p]);
    if (component.grossErrorAt()) rivals[p] = jumps(inquiry, explanation, p, comparison);
    if (component.isEffect() || component.isJump()) rivals[p] = others(inquiry, explanation, p, comparison);
  }
  return rivals;
}

double chanceOf(const Inquiry& inquiry, const Part& part, const std::vector<Rival>& rivals) {
  const auto isCounted = [&](const Part& other) {
    const bool isJump = inquiry.of(part).isJump();  // a jump at any moment counts
    return other.component == part.component || (isJump && inquiry.of(other).isJump()) ||
           std::ranges::any_of(rivals, [&](const Rival& rival) {
             return !rival.isExcluded && rival.part.component == other.component;
           });
  };
  return inquiry.chanceOf(
      [&](const Explanation& explanation) { return std::ranges::any_of(explanation.parts, isCounted); });
}

}  // namespace alidade
