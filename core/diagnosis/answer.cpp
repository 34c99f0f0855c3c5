#include "core/diagnosis/answer.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/gain.h"
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

bool isClose(const Explanation& rival, const Explanation& explanation) {
  constexpr double closeOdds = 3.5;  // natural logarithm: odds of 33
  return rival.logOdds > explanation.logOdds - closeOdds;
}

/// The gain of `instead` in place of the part, all other parts taken off.
Gain gainInstead(const Inquiry& inquiry, const Explanation& explanation, const Part& part,
                 const Part& instead) {
  const Leftover& leftover = inquiry.leftover;
  const auto columnsOf = [&](const Part& any) -> Eigen::MatrixXd {
    if (inquiry.isMisreading(any))
      return leftover.visible(Eigen::VectorXd::Unit(leftover.readings(), inquiry.readingOf(any)));
    return leftover.visible(wholeColumns(leftover, inquiry.candidates[any.component]));
  };
  Eigen::VectorXd left = leftover.residual();
  for (const Part& other : explanation.parts)
    if (&other != &part)
      left -= inquiry.isMisreading(other)
                  ? Eigen::VectorXd(columnsOf(other) * other.weights)
                  : signature(leftover, inquiry.candidates[other.component], other.weights);
  const Eigen::MatrixXd columns = columnsOf(instead);
  const double variance = explanation.noisy ? explanation.noise * explanation.noise : 1;
  return gainOf(widthsOf(inquiry.kindOf(instead)), columns.transpose() * columns, columns.transpose() * left,
                variance);
}

/// With a step in place of a misreading that it would look like.
Explanation withStep(const Inquiry& inquiry, const Explanation& explanation, std::size_t part,
                     std::size_t step) {
  Explanation rival = explanation;
  const Part& misread = explanation.parts[part];
  Part& instead = rival.parts[part];
  instead = {step, 1, Eigen::VectorXd::Zero(2), 0};
  const Gain own = gainInstead(inquiry, explanation, misread, misread);
  const Gain gain = gainInstead(inquiry, explanation, misread, instead);
  instead.width = gain.width;
  instead.logGain = gain.log;
  // Either circle of the row may be the one that was misread.
  const double misreading = std::log(2) + PriorOdds().logOfMisreading(inquiry.leftover.readings());
  const double odds = gain.log + inquiry.candidates[step].logPrior - own.log - misreading;
  rival.logOdds += odds;
  return rival;
}

/// Names what the part looks like, `rival` in its place.
void addLookAlike(Answer& answer, std::size_t part, std::size_t component,
                  const std::optional<Explanation>& rival) {
  answer.lookAlikes[part].push_back(component);
  if (rival) answer.rivals.push_back(*rival);
}

/// The step, where there is one, that leaves what this misreading leaves.
void addSteps(const Inquiry& inquiry, Answer& answer, std::size_t part) {
  const Explanation& explanation = answer.explanation;
  const Eigen::Index reading = inquiry.readingOf(explanation.parts[part]);
  const auto isJump = [&](const Part& other) { return inquiry.kindOf(other) == Component::Kind::Jump; };
  if (std::ranges::any_of(explanation.parts, isJump)) return;  // one jump to a session
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    if (inquiry.candidates[i].onlyRow != inquiry.leftover.reading(reading).sequence) continue;
    const Explanation rival = withStep(inquiry, explanation, part, i);
    if (isClose(rival, explanation)) addLookAlike(answer, part, i, rival);
  }
}

/// Another effect in place of one that is alone; absent where the noise is larger than stated and the search
/// did not meet it.
std::optional<Explanation> withOther(const Inquiry& inquiry, const Explanation& explanation,
                                     std::size_t other) {
  if (explanation.parts.size() != 1) return std::nullopt;
  if (const Explanation* met = inquiry.alone(other, explanation.noisy)) return *met;
  if (explanation.noisy) return std::nullopt;
  const Part& own = explanation.parts.front();
  const Component& component = inquiry.candidates[other];
  Explanation rival = explanation;
  rival.parts = {fitAlone(inquiry.leftover, component, other)};
  rival.logOdds += rival.parts.front().logGain + component.logPrior - own.logGain -
                   inquiry.candidates[own.component].logPrior;
  return rival;
}

void addEffects(const Inquiry& inquiry, Answer& answer, std::size_t index) {
  const Explanation& explanation = answer.explanation;
  const Part& part = explanation.parts[index];
  const Eigen::VectorXd trace = signature(inquiry.leftover, inquiry.candidates[part.component], part.weights);
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    const Component& other = inquiry.candidates[i];
    if (other.kind != Component::Kind::Effect || i == part.component) continue;
    const double difference = differenceFrom(trace, other) / explanation.noise;
    if (difference > clearlyDifferent) continue;
    const std::optional<Explanation> rival = withOther(inquiry, explanation, i);
    if (difference < hardlyDifferent || (rival && isClose(*rival, explanation)))
      addLookAlike(answer, index, i, rival);
  }
}

void addLookAlikes(const Inquiry& inquiry, Answer& answer, std::size_t part) {
  const Component::Kind kind = inquiry.kindOf(answer.explanation.parts[part]);
  if (kind == Component::Kind::Misreading) addSteps(inquiry, answer, part);
  if (kind == Component::Kind::Effect) addEffects(inquiry, answer, part);
}

GapModel modelWith(const Inquiry& inquiry, const Explanation& explanation) {
  return alidade::modelWith(inquiry.base, explanation, inquiry.candidates, inquiry.leftover);
}

}  // namespace

Answer conclude(const Inquiry& inquiry) {
  const Answer::Kind kind = likeliestKind(inquiry);
  if (kind != Answer::Kind::Known) return {kind, {}, {}, {}, inquiry.base};
  Answer answer{kind, bestKnown(inquiry), {}, {}, {}};
  answer.lookAlikes.resize(answer.explanation.parts.size());
  for (std::size_t part = 0; part < answer.explanation.parts.size(); ++part)
    addLookAlikes(inquiry, answer, part);
  answer.after = modelWith(inquiry, answer.explanation);
  return answer;
}

std::optional<IntersectionEstimate> afterwardsOf(const Inquiry& inquiry, const Answer& answer) {
  constexpr double negligible = 1e-3;
  const std::optional<IntersectionEstimate> first = estimateOf(answer.after);
  if (!first) return first;
  double sum = 1, mean = first->value, second = first->sigma * first->sigma + mean * mean;
  for (const Explanation& rival : answer.rivals) {
    const double chance = std::exp(rival.logOdds - answer.explanation.logOdds);
    if (chance < negligible) continue;
    const auto other = estimateOf(modelWith(inquiry, rival));
    sum += chance;
    mean += chance * other->value;
    second += chance * (other->sigma * other->sigma + other->value * other->value);
  }
  if (sum == 1) return first;
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
