#include "core/diagnosis/conclusion/measured.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/adjustment/result/intersection.h"
#include "core/adjustment/result/uncertain_length.h"
#include "core/base/square.h"
#include "core/base/statistics.h"
#include "core/diagnosis/conclusion/afterwards.h"
#include "core/diagnosis/conclusion/linear_move.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/effects/known_sizes.h"

namespace alidade {

namespace {

/// How well a term is known beforehand, and the variance of Δd that comes of it, mm².
struct TermShare {
  double priorSigma = 0, variance = 0;
};

/// Across the plane, and its covariance with Δd, mm².
struct Across {
  MeasuredLength length;
  double covariance = 0;
};

/// One account of the readings: Δd with every effect besides the answer, and what its variance is made of.
struct Account {
  IntersectionEstimate estimate;
  std::map<ErrorTerm, TermShare> terms;
  std::vector<BudgetEntry> others;  ///< the same source may come twice
  NoiseScale noise;
  std::optional<Across> across = {};
};

/// What the estimate of the plane's offset is without what was plausible beforehand, of which it holds the
/// share g = Q/p²: (value − g p₀)/(1 − g). A size that is known stays.
std::optional<Across> acrossOf(const GapModel& model, const std::vector<double>& weights) {
  constexpr double nothingBut = 0.95;  // what is plausible
  constexpr ErrorTerm offset = ErrorTerm::PlaneOffset;
  const JointFit& fit = *model.fit;
  const auto term = std::ranges::find(model.options.terms, offset, &EstimatedTerm::term);
  if (term == model.options.terms.end()) return std::nullopt;
  const Unknown unknown{.kind = Unknown::Kind::Error, .arc = 0, .term = offset};
  const std::size_t index = fit.indexOf(unknown);
  const std::vector<double> own = unitWeights(fit, unknown);
  const NoiseScale noise = noiseScale(fit);
  const std::vector<BudgetEntry> budget = budgetOf(fit, own, noise.factor);
  const bool isKnown = knownOf(*model.measurement, effectOf(offset)->parameters.front()).has_value();
  const double ofPrior = isKnown ? 0 : fit.cofactor(index, index) / square(term->priorSigma);
  if (!(ofPrior < nothingBut)) return std::nullopt;
  const double withPrior = covarianceWith(fit.cofactor, weights, index);
  const double ofReadings = 1 - ofPrior;
  const double variance = square(combined(budget)) - square(ofPrior * term->priorSigma);
  const double sigma = std::sqrt(std::max(variance, 0.0)) / ofReadings;
  const DegreesOfFreedom freedom = effectiveDegreesOfFreedom(
      sigma, std::min(scaledPart(budget) / ofReadings, sigma), noise.degreesOfFreedom);
  return Across{{(fit.values[index] - ofPrior * term->priorValue) / ofReadings, sigma,
                 coverageFactor(model.measurement->coverage, freedom) * sigma},
                (covarianceOf(fit, weights, own, noise.factor) - ofPrior * withPrior) / ofReadings};
}

MeasuredLength distanceOf(const IntersectionEstimate& inPlane, const Across& across) {
  const UncertainLength length = lengthOf({.x = inPlane.value,
                                           .y = across.length.value,
                                           .varianceX = square(inPlane.sigma),
                                           .varianceY = square(across.length.sigma),
                                           .covariance = across.covariance});
  const double factor =
      std::max(inPlane.expanded / inPlane.sigma, across.length.expanded / across.length.sigma);
  return {length.value, length.sigma, factor * length.sigma};
}

std::optional<Account> byFit(const Answer& answer) {
  const GapModel model = withEveryEffect(answer.after);
  const JointFit& fit = *model.fit;
  const std::optional<Intersection> found = intersect(*model.measurement, fit);
  if (!found) return std::nullopt;
  Account account{estimateOf(*found), {}, {}, noiseScale(fit)};
  const std::vector<double> weights =
      intersectionWeights(fit, *arcAt(*model.measurement, 0), *arcAt(*model.measurement, 180));
  for (std::size_t index = 0; index < fit.unknowns.size(); ++index) {
    const Unknown& unknown = fit.unknowns[index];
    if (unknown.kind != Unknown::Kind::Error) continue;
    account.terms[unknown.term] = {fit.priorSigmas[index],
                                   varianceOfPrior(fit, fit.cofactor, weights, index)};
  }
  std::ranges::copy_if(found->budget, std::back_inserter(account.others), [](const BudgetEntry& entry) {
    return entry.source != UncertaintySource::PlausibleSizes;
  });
  account.across = acrossOf(model, weights);
  return account;
}

/// From the answer's own fit by what the effects add to it.
std::optional<Account> byMoves(const Inquiry& inquiry, const Answer& answer, LinearMoves& moves) {
  LinearMoves alone(inquiry);
  const std::optional<Move> with = moves.of(answer.explanation), without = alone.of(answer.explanation);
  const std::optional<Intersection> found = intersect(*answer.after.measurement, *answer.after.fit);
  if (!with || !without || !found) return std::nullopt;
  Account account{estimateOf(*found), {}, found->budget, noiseScale(*answer.after.fit)};
  IntersectionEstimate& estimate = account.estimate;
  const double factor = estimate.expanded / estimate.sigma;
  double ofTerms = 0;
  for (std::size_t i = 0; i < with->ofEffects.size(); ++i) {
    const EstimatedTerm& term = moves.effects()[i];
    account.terms[term.term] = {term.priorSigma, with->ofEffects[i]};
    ofTerms += with->ofEffects[i];
  }
  estimate.value += with->shift - without->shift;
  const double more = std::max(with->variance - without->variance, ofTerms);
  estimate.sigma = std::sqrt(square(estimate.sigma) + more);
  estimate.expanded = factor * estimate.sigma;
  estimate.accounts = {{1, estimate.value, estimate.sigma}};
  account.others.push_back({UncertaintySource::ModelEffects, std::sqrt(more - ofTerms)});
  return account;
}

/// Where no jump is an answer, a step of the orientation is what the pause adds to a drift (`addPause`).
std::map<ErrorTerm, TermShare> withPausesInDrifts(std::map<ErrorTerm, TermShare> terms) {
  using enum ErrorTerm;
  for (const auto& [step, drift] :
       {std::pair{HorizontalJump, HorizontalDrift}, std::pair{VerticalJump, VerticalDrift}}) {
    const auto ofPause = terms.find(step), ofDrift = terms.find(drift);
    if (ofPause == terms.end() || ofDrift == terms.end()) continue;
    ofDrift->second.variance += ofPause->second.variance;
    terms.erase(ofPause);
  }
  return terms;
}

std::vector<UncertaintyShare> sharesOfEffects(const Account& account, const Measurement& measurement) {
  std::vector<UncertaintyShare> shares;
  for (const Effect& effect : effectCatalogue()) {
    UncertaintyShare share{.effect = std::string(effect.id), .from = UncertaintyShare::From::Default};
    double variance = 0;
    for (const EffectParameter& parameter : effect.parameters) {
      const auto term = account.terms.find(parameter.term);
      if (term == account.terms.end()) continue;
      const auto& [priorSigma, ofTerm] = term->second;
      const std::optional<KnownPrior> known = knownOf(measurement, parameter);
      if (priorSigma > (known ? known->sigma : plausibleSize(parameter))) {
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
  for (const auto& [term, share] : account.terms)
    if (!effectOf(term)) ofJump += share.variance;
  if (ofJump > 0)
    shares.push_back({.effect = std::string(jumpId),
                      .from = UncertaintyShare::From::Diagnosis,
                      .sigma = std::sqrt(ofJump)});
  return shares;
}

std::vector<UncertaintyShare> budgetOf(const Account& account, const Measurement& measurement,
                                       const IntersectionEstimate& averaged) {
  using enum UncertaintyShare::From;
  std::vector<UncertaintyShare> shares = sharesOfEffects(account, measurement);
  const double degreesOfFreedom = account.noise.degreesOfFreedom;
  for (const BudgetEntry& entry : account.others) {
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
  const double beyond = square(averaged.sigma) - square(account.estimate.sigma);
  if (beyond > 0) shares.push_back({.from = Diagnosis, .sigma = std::sqrt(beyond)});
  // What else may be the case may be surer: then all shares are less in proportion.
  if (beyond < 0)
    for (UncertaintyShare& share : shares) share.sigma *= averaged.sigma / account.estimate.sigma;
  std::ranges::stable_sort(shares, std::greater(), &UncertaintyShare::sigma);
  return shares;
}

}  // namespace

std::optional<MeasuredIntersection> measuredIntersection(const Inquiry& inquiry, const Answer& answer) {
  const Measurement& measurement = *inquiry.base.measurement;
  if (!hasBothAxes(measurement)) return std::nullopt;
  LinearMoves moves(inquiry, Besides::EveryEffect);
  std::optional<Account> account;
  if (isLarge(measurement)) account = byMoves(inquiry, answer, moves);
  if (!account) account = byFit(answer);
  if (!account) return std::nullopt;
  const auto isJump = [&](const Part& part) { return inquiry.of(part).isJump(); };
  if (std::ranges::none_of(answer.explanation.parts, isJump))
    account->terms = withPausesInDrifts(std::move(account->terms));
  const IntersectionEstimate estimate = averaged(inquiry, answer, account->estimate, moves);
  MeasuredIntersection measured{estimate, budgetOf(*account, measurement, estimate)};
  if (account->across) {
    measured.across = account->across->length;
    measured.distance = distanceOf(estimate, *account->across);
  }
  return measured;
}

}  // namespace alidade
