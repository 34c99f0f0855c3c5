#include "core/diagnosis/answer.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/gap_size.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

/// How likely each kind of answer is as a whole.
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

/// The best explanation of known causes; a smaller one of the same causes where it is nearly as good.
const Explanation& bestKnown(const Inquiry& inquiry) {
  constexpr double nearlyAsGood = 2;  // natural logarithm: odds of 7
  const auto isKnown = [](const Explanation& e) { return !e.shaped && (e.noisy || !e.parts.empty()); };
  const Explanation& best = *std::ranges::find_if(inquiry.explanations, isKnown);
  const Explanation* simplest = &best;
  const auto count = [](const Explanation& e) { return e.parts.size() + (e.noisy ? 1 : 0); };
  for (const Explanation& other : inquiry.explanations)
    if (isKnown(other) && other.logOdds > best.logOdds - nearlyAsGood && count(other) < count(*simplest) &&
        isPartOf(other, best))
      simplest = &other;
  return *simplest;
}

GapModel modelWith(const Inquiry& inquiry, const Explanation& explanation) {
  return alidade::modelWith(inquiry.base, explanation, inquiry.candidates, inquiry.leftover);
}

Answer nothingIn(const Inquiry& inquiry) {
  return {Answer::Kind::Nothing, {}, {}, {}, inquiry.base};
}

Answer knownAs(const Inquiry& inquiry, const Explanation& explanation) {
  return {
      Answer::Kind::Known, explanation, rivalsOf(inquiry, explanation), {}, modelWith(inquiry, explanation)};
}

/// The likeliest pattern, and beside it what is as good as certain.
Answer unknownIn(const Inquiry& inquiry) {
  constexpr double certain = 0.95;
  const Explanation& shaped = *std::ranges::find_if(inquiry.explanations, &Explanation::shaped);
  const std::vector<std::vector<Rival>> rivals = rivalsOf(inquiry, shaped);
  Answer answer{Answer::Kind::Unknown, {}, {}, shaped.parts.back(), {}};
  for (std::size_t p = 0; p + 1 < shaped.parts.size(); ++p) {
    if (chanceOf(inquiry, shaped.parts[p], rivals[p]) < certain) continue;
    answer.explanation.parts.push_back(shaped.parts[p]);
    answer.rivals.push_back(rivals[p]);
  }
  answer.after = modelWith(inquiry, answer.explanation);
  return answer;
}

/// Whether any of its parts, or what looks like it, is likelier than that.
bool isLikelier(const Inquiry& inquiry, const Answer& answer, double chance) {
  if (answer.explanation.noisy && inquiry.probabilityOf(noiseId) > chance) return true;
  for (std::size_t p = 0; p < answer.rivals.size(); ++p)
    if (chanceOf(inquiry, answer.explanation.parts[p], answer.rivals[p]) > chance) return true;
  return false;
}

}  // namespace

Answer conclude(const Inquiry& inquiry) {
  constexpr double hardlyNoise = 1e-3;  // what known causes leave may not be less likely by noise alone
  const auto [nothing, known, unknown] = chancesOf(inquiry);
  if (unknown > known && unknown > nothing) return unknownIn(inquiry);
  if (nothing >= known) return nothingIn(inquiry);
  Answer answer = knownAs(inquiry, bestKnown(inquiry));
  // Many causes may each be a little likely, and none of them more than that.
  if (!isLikelier(inquiry, answer, std::max(nothing, unknown)))
    return nothing >= unknown ? nothingIn(inquiry) : unknownIn(inquiry);
  const bool isNoise = !(sizeOf(answer.after).pValue < hardlyNoise);  // or nothing tells
  if (answer.explanation.noisy || isNoise) return answer;
  const auto more = std::ranges::find_if(
      inquiry.explanations, [](const Explanation& other) { return other.shaped || other.noisy; });
  if (more == inquiry.explanations.end()) return answer;
  return more->shaped ? unknownIn(inquiry) : knownAs(inquiry, *more);
}

std::vector<GapStep> stepsOf(const Inquiry& inquiry, const Answer& answer) {
  std::vector<GapStep> steps;
  const Explanation& whole = answer.explanation;
  Explanation soFar;
  const auto note = [&](std::string_view id) {
    const bool isLast = soFar.parts.size() == whole.parts.size() && soFar.noisy == whole.noisy;
    const GapModel& model = isLast ? answer.after : modelWith(inquiry, soFar);
    steps.push_back({std::string(id), sizeOf(model), estimateOf(model)});
  };
  for (const Part& part : whole.parts)
    if (inquiry.isMisreading(part)) soFar.parts.push_back(part);
  if (!soFar.parts.empty() || !inquiry.farOff.empty()) note(misreadingId);
  for (const Part& part : whole.parts) {
    if (inquiry.isMisreading(part)) continue;
    soFar.parts.push_back(part);
    note(inquiry.idOf(part));
  }
  if (whole.noisy) {
    soFar.noisy = true;
    note(noiseId);
  }
  return steps;
}

}  // namespace alidade
