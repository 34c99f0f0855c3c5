#include "core/diagnosis/conclusion/unexplained.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/square.h"
#include "core/base/statistics.h"
#include "core/diagnosis/gap/gap_size.h"

namespace alidade {

namespace {

/// ln B(z) for a two-sided probability.
double logBayesFactorOfMore(double chance) {
  constexpr double least = 1e-300;
  const double z = -normalQuantile(std::clamp(chance, least, 1.0) / 2);
  return z > 1 ? (z * z - 1) / 2 - std::log(z) : 0;
}

/// (m² − s²)₊, mm².
double excessOf(const Closure& closure) {
  return std::max(square(closure.value) - square(closure.sigma), 0.0);
}

/// The unexplained part of a model without a pattern.
Unexplained leftBy(const GapModel& closed, const GapModel& opened) {
  constexpr double perMisclosure = 0.5;  // Δd is half of the difference in y
  const double ofNoise = sizeOf(closed).pValue;
  double most = std::isnan(ofNoise) ? 0 : chanceOfMore(ofNoise), variance = 0;
  for (const Closure& closure : everyClosureOf(opened)) {
    if (closure.of == Closure::Of::Reference) continue;
    const double more = chanceOfMore(closure.chance);
    most = std::max(most, more);
    variance += more * square(perMisclosure) * excessOf(closure);
  }
  return {most, std::sqrt(variance)};
}

/// The average over the likeliest explanations without a pattern.
Unexplained leftByNamed(const Inquiry& inquiry, const Answer& answer) {
  constexpr std::size_t mostFitted = 5;
  constexpr double leastChance = 0.02;
  double all = 0, chance = 0, variance = 0;
  std::size_t fitted = 0;
  for (const Explanation& explanation : inquiry.explanations) {
    if (explanation.shaped) continue;
    if (fitted > 0 && (fitted == mostFitted || explanation.chance < leastChance)) break;
    const bool isAnswer = answer.kind == Answer::Kind::Known && areAlike(explanation, answer.explanation);
    const ExplainedModel model =
        isAnswer ? ExplainedModel{answer.after, answer.opened} : explainedModel(inquiry, explanation);
    const Unexplained left = leftBy(model.closed, model.opened);
    all += explanation.chance;
    chance += explanation.chance * left.chance;
    variance += explanation.chance * square(left.sigma);
    ++fitted;
  }
  if (!(all > 0)) return {};
  return {std::min(chance / all, 1.0), std::sqrt(variance / all)};
}

}  // namespace

std::vector<Closure> everyClosureOf(const GapModel& model) {
  std::vector<Closure> closures = closuresOf(*model.measurement, *model.fit);
  if (const auto apart = fitApart(*model.measurement, model.starts, model.options))
    std::ranges::move(repeatsOf(*model.measurement, *apart), std::back_inserter(closures));
  std::ranges::move(zeroClosuresOf(*model.measurement, *model.fit, model.options),
                    std::back_inserter(closures));
  return closures;
}

double chanceOfMore(double chance) {
  return 1 / (1 + std::exp(logBayesFactorOfMore(improbable) - logBayesFactorOfMore(chance)));
}

Unexplained unexplainedOf(const Inquiry& inquiry, const Answer& answer,
                          const std::optional<Closure>& reference) {
  const double beyond = inquiry.chanceOf(&Explanation::shaped);
  const double every = answer.everyEffect ? beyond * answer.everyEffect->chance : 0, shaped = beyond - every;
  const Unexplained named = beyond < 1 ? leftByNamed(inquiry, answer) : Unexplained{};
  const Unexplained together =
      every > 0 ? leftBy(answer.everyEffect->closed, answer.everyEffect->opened) : Unexplained{};
  Unexplained unexplained{shaped + (1 - beyond) * named.chance + every * together.chance,
                          std::sqrt((1 - beyond) * square(named.sigma) + every * square(together.sigma))};
  if (!reference) return unexplained;
  const double more = chanceOfMore(reference->chance);
  unexplained.chance = std::max(unexplained.chance, more);
  unexplained.sigma = std::sqrt(square(unexplained.sigma) + more * excessOf(*reference));
  return unexplained;
}

}  // namespace alidade
