#include "core/diagnosis/conclusion/unexplained.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/random_source.h"
#include "core/base/square.h"
#include "core/diagnosis/gap/gap_size.h"

namespace alidade {

namespace {

constexpr double evenAt = 1e-3;  // as `fails` has it

/// ln B(z) of a two-sided chance.
double logBayesFactorOfMore(double chance) {
  constexpr double least = 1e-300;
  const double z = -normalQuantile(std::clamp(chance, least, 1.0) / 2);
  return z > 1 ? (z * z - 1) / 2 - std::log(z) : 0;
}

/// (m² − s²)₊, mm².
double excessOf(const Closure& closure) {
  return std::max(square(closure.value) - square(closure.sigma), 0.0);
}

/// Of one explanation.
Unexplained leftBy(const Inquiry& inquiry, const Explanation& explanation) {
  constexpr double perMisclosure = 0.5;  // Δd is half of what y differs by
  if (explanation.shaped) return {1, 0};
  const ExplainedModel model = explainedModel(inquiry, explanation);
  const double ofNoise = sizeOf(model.closed).pValue;
  double most = std::isnan(ofNoise) ? 0 : chanceOfMore(ofNoise), variance = 0;
  for (const Closure& closure : closuresWithRepeats(model.opened)) {
    if (closure.of == Closure::Of::Reference) continue;
    const double more = chanceOfMore(closure.chance);
    most = std::max(most, more);
    variance += more * square(perMisclosure) * excessOf(closure);
  }
  return {most, std::sqrt(variance)};
}

}  // namespace

std::vector<Closure> closuresWithRepeats(const GapModel& model) {
  std::vector<Closure> closures = closuresOf(*model.measurement, *model.fit);
  if (const auto apart = fitApart(*model.measurement, model.starts, model.options))
    std::ranges::move(repeatsOf(*model.measurement, *apart), std::back_inserter(closures));
  return closures;
}

double chanceOfMore(double chance) {
  return 1 / (1 + std::exp(logBayesFactorOfMore(evenAt) - logBayesFactorOfMore(chance)));
}

Unexplained unexplainedOf(const Inquiry& inquiry, const std::optional<Closure>& reference) {
  constexpr std::size_t most = 16;
  constexpr double leastChance = 0.01;
  double all = 0, chance = 0, variance = 0;
  const std::size_t count = std::min(most, inquiry.explanations.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Explanation& explanation = inquiry.explanations[i];
    if (i > 0 && explanation.chance < leastChance) break;
    const Unexplained left = leftBy(inquiry, explanation);
    all += explanation.chance;
    chance += explanation.chance * left.chance;
    variance += explanation.chance * square(left.sigma);
  }
  Unexplained unexplained;
  if (all > 0) unexplained = {std::min(chance / all, 1.0), std::sqrt(variance / all)};
  if (reference) {
    const double more = chanceOfMore(reference->chance);
    unexplained.chance = std::max(unexplained.chance, more);
    unexplained.sigma = std::sqrt(square(unexplained.sigma) + more * excessOf(*reference));
  }
  return unexplained;
}

}  // namespace alidade
