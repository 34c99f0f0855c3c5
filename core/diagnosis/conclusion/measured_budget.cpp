#include "core/diagnosis/conclusion/measured_budget.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/base/square.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/effects/known_sizes.h"

namespace alidade {

namespace {

std::vector<UncertaintyShare> sharesOfEffects(const FittedExplanation& fitted,
                                              const Measurement& measurement) {
  constexpr double rounding = 1e-9;
  std::vector<UncertaintyShare> shares;
  for (const Effect* effect : effectsOf(measurement)) {
    UncertaintyShare share{.effect = std::string(effect->id), .from = UncertaintyShare::From::Default};
    double variance = 0;
    for (const EffectParameter& parameter : effect->parameters) {
      const auto term = fitted.terms.find(parameter.term);
      if (term == fitted.terms.end()) continue;
      const auto& [priorSigma, ofTerm] = term->second;
      const std::optional<KnownPrior> known = knownOf(measurement, parameter);
      const double usual = known ? known->sigma : plausibleSize(parameter) * fitted.scales.of(*effect);
      if (priorSigma > usual * (1 + rounding)) {
        share.from = UncertaintyShare::From::Diagnosis;
      } else if (known) {
        share.from = UncertaintyShare::From::Known;
        share.reference = known->from;
      }
      variance += ofTerm;
      share.sizes.push_back({std::string(parameter.name), priorSigma / modelUnitsPer(parameter.unit),
                             std::string(parameter.unit)});
    }
    share.sigma = std::sqrt(variance);
    if (!share.sizes.empty()) shares.push_back(std::move(share));
  }
  double ofJump = 0;
  for (const auto& [term, share] : fitted.terms)
    if (isOfJump(term)) ofJump += share.variance;
  if (ofJump > 0)
    shares.push_back({.effect = std::string(jumpId),
                      .from = UncertaintyShare::From::Diagnosis,
                      .sigma = std::sqrt(ofJump)});
  return shares;
}

}  // namespace

std::vector<UncertaintyShare> budgetOf(const FittedExplanation& fitted, const Measurement& measurement,
                                       const IntersectionEstimate& averaged) {
  using enum UncertaintyShare::From;
  std::vector<UncertaintyShare> shares = sharesOfEffects(fitted, measurement);
  const double degreesOfFreedom = fitted.noise.degreesOfFreedom;
  for (const BudgetEntry& entry : fitted.others) {
    const bool isOfReadings =
        entry.source == UncertaintySource::Readings || entry.source == UncertaintySource::ModelEffects;
    if (isOfReadings)
      shares.push_back({.source = entry.source,
                        .type = UncertaintyShare::Type::A,
                        .from = std::isfinite(degreesOfFreedom) ? Scatter : Stated,
                        .sigma = entry.sigma,
                        .degreesOfFreedom = degreesOfFreedom});
    else
      shares.push_back({.source = entry.source, .sigma = entry.sigma});
  }
  const double beyond = square(averaged.sigma) - square(fitted.estimate.sigma);
  if (beyond > 0) shares.push_back({.from = Diagnosis, .sigma = std::sqrt(beyond)});
  // An average with smaller σ than the explanation reduces all shares in proportion.
  if (beyond < 0)
    for (UncertaintyShare& share : shares) share.sigma *= averaged.sigma / fitted.estimate.sigma;
  std::ranges::stable_sort(shares, std::greater(), &UncertaintyShare::sigma);
  return shares;
}

}  // namespace alidade
