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

bool isEffect(const Inquiry& inquiry, const Part& part) {
  return !inquiry.isMisreading(part) && inquiry.candidates[part.component].kind == Component::Kind::Effect;
}

constexpr double closeOdds = 3.5;  // natural logarithm: odds of 33

/// The gain of a component in place of the part, all other parts taken off.
Gain gainInstead(const Inquiry& inquiry, const Explanation& explanation, const Part& part,
                 std::size_t component) {
  const Leftover& leftover = inquiry.leftover;
  const auto columnsOf = [&](std::size_t index) -> Eigen::MatrixXd {
    if (index < inquiry.candidates.size())
      return leftover.visible(wholeColumns(leftover, inquiry.candidates[index]));
    const auto reading = static_cast<Eigen::Index>(index - inquiry.candidates.size());
    return leftover.visible(Eigen::VectorXd::Unit(leftover.readings(), reading));
  };
  Eigen::VectorXd left = leftover.residual();
  for (const Part& other : explanation.parts)
    if (&other != &part)
      left -= inquiry.isMisreading(other)
                  ? Eigen::VectorXd(columnsOf(other.component) * other.weights)
                  : signature(leftover, inquiry.candidates[other.component], other.weights);
  const Eigen::MatrixXd columns = columnsOf(component);
  const auto kind = component < inquiry.candidates.size() ? inquiry.candidates[component].kind
                                                          : Component::Kind::Misreading;
  const double variance = explanation.noisy ? explanation.noise * explanation.noise : 1;
  return gainOf(widthsOf(kind), columns.transpose() * columns, columns.transpose() * left, variance);
}

/// With a step in place of a misreading that it would look like.
Explanation withStep(const Inquiry& inquiry, const Explanation& explanation, std::size_t part,
                     std::size_t step) {
  Explanation rival = explanation;
  const Part& misread = explanation.parts[part];
  const Gain own = gainInstead(inquiry, explanation, misread, misread.component);
  const Gain gain = gainInstead(inquiry, explanation, misread, step);
  // Either circle of the row may be the one that was misread.
  const double misreading =
      std::log(2 * PriorOdds().misreading / static_cast<double>(inquiry.leftover.readings()));
  const double odds = gain.log + inquiry.candidates[step].logPrior - own.log - misreading;
  rival.logOdds += odds;
  rival.parts[part] = {step, gain.width, Eigen::VectorXd::Zero(2), gain.log};
  return rival;
}

/// The step, where there is one, that leaves what this misreading leaves.
std::vector<std::size_t> stepsLike(const Inquiry& inquiry, const Explanation& explanation, std::size_t part) {
  const Eigen::Index reading = inquiry.readingOf(explanation.parts[part]);
  const auto isJump = [&](const Part& other) {
    return !inquiry.isMisreading(other) && inquiry.candidates[other.component].kind == Component::Kind::Jump;
  };
  std::vector<std::size_t> found;
  if (std::ranges::any_of(explanation.parts, isJump)) return found;  // one jump to a session
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i)
    if (inquiry.candidates[i].onlyRow == inquiry.leftover.reading(reading).sequence &&
        withStep(inquiry, explanation, part, i).logOdds > explanation.logOdds - closeOdds)
      found.push_back(i);
  return found;
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

std::vector<std::size_t> lookAlikesOf(const Inquiry& inquiry, const Explanation& explanation,
                                      std::size_t index) {
  const Part& part = explanation.parts[index];
  if (inquiry.isMisreading(part)) return stepsLike(inquiry, explanation, index);
  std::vector<std::size_t> found;
  if (!isEffect(inquiry, part)) return found;
  const Eigen::VectorXd trace = signature(inquiry.leftover, inquiry.candidates[part.component], part.weights);
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    const Component& other = inquiry.candidates[i];
    if (other.kind != Component::Kind::Effect || i == part.component) continue;
    const double difference = differenceFrom(trace, other) / explanation.noise;
    if (difference > clearlyDifferent) continue;
    const auto isClose = [&] {
      const std::optional<Explanation> rival = withOther(inquiry, explanation, i);
      return rival && rival->logOdds > explanation.logOdds - closeOdds;
    };
    if (difference < hardlyDifferent || isClose()) found.push_back(i);
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
  for (std::size_t part = 0; part < answer.explanation.parts.size(); ++part)
    answer.lookAlikes.push_back(lookAlikesOf(inquiry, answer.explanation, part));
  answer.after = modelWith(inquiry, answer.explanation);
  return answer;
}

namespace {

/// What could be the case instead, with the odds of it: where an effect is alone another one, and for a
/// misreading the step that looks like it.
std::vector<Explanation> rivalsOf(const Inquiry& inquiry, const Answer& answer) {
  std::vector<Explanation> rivals;
  const Explanation& explanation = answer.explanation;
  for (std::size_t part = 0; part < explanation.parts.size(); ++part)
    for (const std::size_t i : answer.lookAlikes[part]) {
      const std::optional<Explanation> rival = inquiry.isMisreading(explanation.parts[part])
                                                   ? withStep(inquiry, explanation, part, i)
                                                   : withOther(inquiry, explanation, i);
      if (rival) rivals.push_back(*rival);
    }
  return rivals;
}

}  // namespace

std::optional<IntersectionEstimate> afterwardsOf(const Inquiry& inquiry, const Answer& answer) {
  constexpr double negligible = 1e-3;
  const std::optional<IntersectionEstimate> first = estimateOf(answer.after);
  if (!first) return first;
  double sum = 1, mean = first->value, second = first->sigma * first->sigma + mean * mean;
  for (const Explanation& rival : rivalsOf(inquiry, answer)) {
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
