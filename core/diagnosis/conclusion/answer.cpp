#include "core/diagnosis/conclusion/answer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/statistics.h"
#include "core/diagnosis/conclusion/unexplained.h"
#include "core/diagnosis/conclusion/weighed_explanations.h"
#include "core/diagnosis/conclusion/with_forms.h"
#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/diagnosis/search/explained_model.h"
#include "core/effects/cause_ids.h"
#include "core/effects/known_sizes.h"

namespace alidade {

namespace {

/// Total probability of each kind of answer.
struct Chances {
  double nothing = 0, known = 0, unknown = 0;
};

Chances chancesOf(const Inquiry& inquiry) {
  Chances chances;
  for (const Explanation& explanation : inquiry.explanations) {
    if (explanation.shaped)
      chances.unknown += explanation.chance;
    else if (explanation.parts.empty() && !explanation.noisy)
      chances.nothing += explanation.chance;
    else
      chances.known += explanation.chance;
  }
  return chances;
}

/// The likeliest explanation of a kind; null if there is none.
template <typename Kind>
const Explanation* likeliest(const Inquiry& inquiry, const Kind& isOfKind) {
  const auto found = std::ranges::find_if(inquiry.explanations, isOfKind);
  return found == inquiry.explanations.end() ? nullptr : &*found;
}

bool isKnown(const Explanation& explanation) {
  return !explanation.shaped && (explanation.noisy || !explanation.parts.empty());
}

/// The best explanation by known causes, or a nearly as good one by fewer of the same causes. Null if no
/// explanation consists of known causes.
const Explanation* bestKnown(const Inquiry& inquiry) {
  const Explanation* const best = likeliest(inquiry, isKnown);
  const Explanation* simplest = best;
  const auto count = [](const Explanation& e) { return e.parts.size() + (e.noisy ? 1 : 0); };
  for (const Explanation& other : inquiry.explanations)
    if (best && isKnown(other) && other.logPosteriorOdds > best->logPosteriorOdds - thresholds.nearlyAsGood &&
        count(other) < count(*simplest) && isPartOf(other, *best))
      simplest = &other;
  return simplest;
}

GapModel modelWith(const Inquiry& inquiry, const Explanation& explanation) {
  return alidade::modelWith(inquiry.base, explanation, inquiry.candidates, inquiry.leftover);
}

/// Returns the model whose Δd is reported. `closed` is the inquiry's model with the explanation in it.
GapModel measuredModel(const Inquiry& inquiry, const Explanation& explanation, const GapModel& closed) {
  const auto isReading = [&](const Part& part) { return inquiry.of(part).grossErrorAt().has_value(); };
  if (!closed.options.isClosed || !std::ranges::all_of(explanation.parts, isReading)) return closed;
  if (explanation.parts.empty() && !explanation.noisy) return inquiry.expected;
  return alidade::modelWith(inquiry.expected, explanation, inquiry.candidates, inquiry.leftover);
}

/// Drops effects beside a bent one that the nonlinear fit hardly needs: the equations of the search have the
/// second order of a large plane tilt, and put its third into other effects.
Explanation withoutIdleEffects(const Inquiry& inquiry, Explanation found) {
  constexpr double least = 9;  // increase of χ² without a needed effect
  const auto isBent = [&](const Part& part) { return inquiry.of(part).response() == Response::Bent; };
  if (found.noisy || std::ranges::none_of(found.parts, isBent)) return found;
  double left = modelWith(inquiry, found).fit->chiSquare;
  for (std::size_t p = found.parts.size(); p-- > 0;) {
    if (isBent(found.parts[p]) || !inquiry.of(found.parts[p]).isEffect()) continue;
    Explanation fewer = found;
    fewer.parts.erase(fewer.parts.begin() + static_cast<std::ptrdiff_t>(p));
    const double without = modelWith(inquiry, fewer).fit->chiSquare;
    if (without - left > least) continue;
    found = std::move(fewer);
    left = without;
  }
  return found;
}

Answer nothingIn(const Inquiry& inquiry) {
  return {Answer::Kind::Nothing, {}, {}, {}, inquiry.base};
}

Answer knownAs(const Inquiry& inquiry, const Explanation& explanation) {
  return {
      Answer::Kind::Known, explanation, rivalsOf(inquiry, explanation), {}, modelWith(inquiry, explanation)};
}

/// The likeliest pattern, and each further cause with a probability of at least `thresholds.certain`.
Answer unknownAs(const Inquiry& inquiry, const Explanation& shaped) {
  const std::vector<std::vector<Rival>> rivals = rivalsOf(inquiry, shaped);
  Answer answer{Answer::Kind::Unknown, {}, {}, shaped.parts.back(), {}};
  for (std::size_t p = 0; p + 1 < shaped.parts.size(); ++p) {
    if (chanceOf(inquiry, shaped.parts[p], rivals[p]) < thresholds.certain) continue;
    answer.explanation.parts.push_back(shaped.parts[p]);
    answer.rivals.push_back(rivals[p]);
  }
  answer.after = modelWith(inquiry, answer.explanation);
  return answer;
}

/// The answer by every effect of the catalogue at its plausible size, weighed against any pattern with
/// effects of any size. It contains the causes that are certain in addition to the effects. Absent if the
/// readings do not determine its model.
std::optional<Answer> severalIn(const Inquiry& inquiry) {
  constexpr EffectScales asPlausible;
  WeighedExplanations weighed(inquiry);
  weighed.alsoAt(withEveryEffect(inquiry.base), {}, {});
  double shaped = impossible, named = impossible, most = impossible;
  const Explanation* best = nullptr;
  std::vector<std::pair<const Explanation*, double>> all;
  for (const Explanation& explanation : inquiry.explanations) {
    if (explanation.chance < thresholds.leastAveraged && explanation.parts.size() > 1) continue;
    for (const WeighedExplanation& one : weighed.of(explanation)) {
      if (!explanation.shaped && one.scales != asPlausible) continue;
      double& sum = explanation.shaped ? shaped : named;
      sum = logSum(sum, one.logOdds);
      if (explanation.shaped) continue;
      all.emplace_back(&explanation, one.logOdds);
      if (one.logOdds <= most) continue;
      most = one.logOdds;
      best = &explanation;
    }
  }
  if (!best) return std::nullopt;
  Answer answer{Answer::Kind::Several, {}, {}, {}, {}};
  for (const Part& part : best->parts) {
    double chance = 0;
    for (const auto& [explanation, logOdds] : all)
      if (explanation->has(part.component)) chance += std::exp(logOdds - named);
    if (chance >= thresholds.certain && !inquiry.of(part).isEffect())
      answer.explanation.parts.push_back(part);
  }
  answer.rivals.resize(answer.explanation.parts.size());
  answer.after = withEveryEffect(modelWith(inquiry, answer.explanation));
  if (!answer.after.fit->isDetermined()) return std::nullopt;
  answer.everyEffect = {std::exp(named - logSum(named, shaped)), answer.after,
                        openedModelOf(answer.after, inquiry.own)};
  return answer;
}

/// The likeliest pattern or every effect, whichever is likelier.
Answer beyondCatalogue(const Inquiry& inquiry, const Explanation& shaped) {
  constexpr double even = 0.5;
  std::optional<Answer> several = severalIn(inquiry);
  if (several && several->everyEffect->chance >= even) return *std::move(several);
  Answer answer = unknownAs(inquiry, shaped);
  if (several) answer.everyEffect = std::move(several->everyEffect);
  return answer;
}

/// Whether a part of the answer, together with its look-alikes, is likelier than `chance`.
bool isLikelier(const Inquiry& inquiry, const Answer& answer, double chance) {
  if (answer.explanation.noisy && inquiry.probabilityOf(noiseId) > chance) return true;
  for (std::size_t p = 0; p < answer.rivals.size(); ++p)
    if (chanceOf(inquiry, answer.explanation.parts[p], answer.rivals[p]) > chance) return true;
  return false;
}

/// A real gap without an explanation.
Answer unexplained(const Inquiry& inquiry) {
  return {Answer::Kind::Unknown, {}, {}, {}, inquiry.base};
}

Answer likeliestAnswer(const Inquiry& inquiry) {
  const auto [nothing, known, unknown] = chancesOf(inquiry);
  const Explanation* const best = bestKnown(inquiry);
  const Explanation* const shaped = likeliest(inquiry, &Explanation::shaped);
  if (shaped && unknown > known && unknown > nothing) return beyondCatalogue(inquiry, *shaped);
  if (!best || nothing >= known) return nothingIn(inquiry);
  Answer answer = knownAs(inquiry, withoutIdleEffects(inquiry, *best));
  // Many causes may share the probability although none of them is likelier than the alternative.
  if (!isLikelier(inquiry, answer, std::max(nothing, unknown)))
    return !shaped || nothing >= unknown ? nothingIn(inquiry) : beyondCatalogue(inquiry, *shaped);
  const bool isNoise = !(sizeOf(answer.after).pValue < improbable);  // true without a p-value
  if (answer.explanation.noisy || isNoise) return answer;
  const Explanation* const more =
      likeliest(inquiry, [](const Explanation& other) { return other.shaped || other.noisy; });
  if (!more) return answer;
  return more->shaped ? beyondCatalogue(inquiry, *more) : knownAs(inquiry, *more);
}

}  // namespace

Answer conclude(const Inquiry& inquiry) {
  Answer answer = likeliestAnswer(inquiry);
  answer.measured = measuredModel(inquiry, answer.explanation, answer.after);
  // The answer comes from the linear model; the readings may not determine its nonlinear model.
  if (!answer.after.fit->isDetermined() || !answer.measured.fit->isDetermined()) {
    answer = unexplained(inquiry);
    answer.measured = inquiry.expected;
  }
  answer.opened = openedModelOf(answer.measured, inquiry.own);
  return answer;
}

ExplainedModel explainedModel(const Inquiry& inquiry, Explanation explanation) {
  std::erase_if(explanation.parts, [&](const Part& part) { return inquiry.of(part).isShape(); });
  GapModel closed =
      explanation.parts.empty() && !explanation.noisy ? inquiry.base : modelWith(inquiry, explanation);
  GapModel opened = openedModelOf(measuredModel(inquiry, explanation, closed), inquiry.own);
  return {std::move(closed), std::move(opened)};
}

std::vector<GapStep> stepsOf(const Inquiry& inquiry, const Answer& answer) {
  std::vector<GapStep> steps;
  const Explanation& whole = answer.explanation;
  const bool formed = hasForms(inquiry, answer);
  Explanation soFar;
  const auto add = [&](std::string_view id, const GapModel& opened, const GapModel& measured) {
    steps.push_back({std::string(id), sizeOf(opened), estimateOf(measured), everyClosureOf(opened)});
  };
  const auto note = [&](std::string_view id) {
    const bool isLast = !formed && soFar.parts.size() == whole.parts.size() && soFar.noisy == whole.noisy;
    const GapModel& model = isLast ? answer.after : modelWith(inquiry, soFar);
    if (!model.fit->isDetermined()) return;
    if (isLast) return add(id, answer.opened, answer.measured);
    const GapModel measured = measuredModel(inquiry, soFar, model);
    add(id, openedModelOf(measured, inquiry.own), measured);
  };
  if (isAnythingKnown(*inquiry.base.measurement)) add(knownId, inquiry.expected, inquiry.expected);
  for (const Part& part : whole.parts)
    if (inquiry.of(part).grossErrorAt()) soFar.parts.push_back(part);
  if (!soFar.parts.empty() || !inquiry.excluded.empty()) note(grossErrorId);
  for (const Part& part : whole.parts) {
    if (inquiry.of(part).grossErrorAt()) continue;
    soFar.parts.push_back(part);
    note(inquiry.of(part).id());
  }
  if (whole.noisy) {
    soFar.noisy = true;
    note(noiseId);
  }
  if (formed) add(formId, answer.opened, answer.measured);
  return steps;
}

}  // namespace alidade
