#include "core/diagnosis/answer.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/gap_size.h"
#include "core/diagnosis/look_alikes.h"

namespace alidade {

namespace {

Answer::Kind likeliestKind(const Inquiry& inquiry) {
  double nothing = 0, known = 0, unknown = 0;
  for (const Explanation& explanation : inquiry.explanations) {
    if (explanation.shaped)
      unknown += explanation.chance;
    else if (explanation.parts.empty() && !explanation.noisy)
      nothing += explanation.chance;
    else
      known += explanation.chance;
  }
  if (unknown > known && unknown > nothing) return Answer::Kind::Unknown;
  return nothing >= known ? Answer::Kind::Nothing : Answer::Kind::Known;
}

bool isPartOf(const Explanation& smaller, const Explanation& larger) {
  if (smaller.noisy && !larger.noisy) return false;
  return std::ranges::all_of(smaller.parts, [&](const Part& part) {
    return std::ranges::find(larger.parts, part.component, &Part::component) != larger.parts.end();
  });
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

bool isEffect(const Inquiry& inquiry, const Part& part) {
  return !inquiry.isMisreading(part) && inquiry.candidates[part.component].kind == Component::Kind::Effect;
}

std::vector<std::size_t> lookAlikesOf(const Inquiry& inquiry, const Explanation& explanation,
                                      const Part& part) {
  constexpr double closeOdds = 3.5;  // natural logarithm: odds of 33
  std::vector<std::size_t> found;
  if (!isEffect(inquiry, part)) return found;
  const Eigen::VectorXd trace = signature(inquiry.leftover, inquiry.candidates[part.component], part.weights);
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    const Component& other = inquiry.candidates[i];
    if (other.kind != Component::Kind::Effect || i == part.component) continue;
    const double difference = differenceFrom(trace, other) / explanation.noise;
    if (difference > clearlyDifferent) continue;
    const Explanation* rival = explanation.parts.size() == 1 ? inquiry.alone(i, explanation.noisy) : nullptr;
    const bool close = rival && rival->logOdds > explanation.logOdds - closeOdds;
    if (difference < hardlyDifferent || close) found.push_back(i);
  }
  return found;
}

GapModel modelWith(const Inquiry& inquiry, const Explanation& explanation) {
  return alidade::modelWith(inquiry.base, explanation, inquiry.candidates, inquiry.leftover);
}

}  // namespace

Answer conclude(const Inquiry& inquiry) {
  const Answer::Kind kind = likeliestKind(inquiry);
  if (kind != Answer::Kind::Known) return {kind, {}, {}, inquiry.base};
  Answer answer{kind, bestKnown(inquiry), {}, {}};
  for (const Part& part : answer.explanation.parts)
    answer.lookAlikes.push_back(lookAlikesOf(inquiry, answer.explanation, part));
  answer.after = modelWith(inquiry, answer.explanation);
  return answer;
}

std::optional<IntersectionEstimate> afterwardsOf(const Inquiry& inquiry, const Answer& answer) {
  constexpr double negligible = 1e-3;
  const Explanation& explanation = answer.explanation;
  const std::optional<IntersectionEstimate> first = estimateOf(answer.after);
  if (!first || explanation.parts.size() != 1) return first;
  double sum = 1, mean = first->value, second = first->sigma * first->sigma + mean * mean;
  for (const std::size_t i : answer.lookAlikes.front()) {
    const Explanation* rival = inquiry.alone(i, explanation.noisy);
    if (!rival) continue;
    const double chance = std::exp(rival->logOdds - explanation.logOdds);
    if (chance < negligible) continue;
    const auto other = estimateOf(modelWith(inquiry, *rival));
    sum += chance;
    mean += chance * other->value;
    second += chance * (other->sigma * other->sigma + other->value * other->value);
  }
  mean /= sum;
  const double sigma = std::sqrt(std::max(second / sum - mean * mean, 0.0));
  return IntersectionEstimate{mean, sigma, sigma * (first->expanded / first->sigma)};
}

std::vector<GapStep> stepsOf(const Inquiry& inquiry, const Answer& answer) {
  std::vector<GapStep> steps;
  const Explanation& whole = answer.explanation;
  Explanation soFar;
  const auto note = [&](const std::string& id) {
    const bool isLast = soFar.parts.size() == whole.parts.size() && soFar.noisy == whole.noisy;
    const GapModel& model = isLast ? answer.after : modelWith(inquiry, soFar);
    steps.push_back({id, sizeOf(model), estimateOf(model)});
  };
  for (const Part& part : whole.parts) {
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
