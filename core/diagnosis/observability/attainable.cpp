#include "core/diagnosis/observability/attainable.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "core/adjustment/result/intersection.h"
#include "core/base/square.h"
#include "core/diagnosis/observability/further_readings.h"
#include "core/effects/catalogue.h"

namespace alidade {

namespace {

/// Returns the model of an error-free set of readings with every effect as an unknown. It excludes past
/// jumps. The known radius and the known sizes are the set's own, so that the fit starts at its minimum.
GapModel plannedModel(const GapModel& model, const Measurement& set, double noise,
                      const EffectScales& scales) {
  GapModel planned;
  planned.options.isClosed = model.options.isClosed;
  for (const ArcMeasurement& arc : set.arcs)
    planned.starts.push_back(model.fit->circleOf(arcAt(*model.measurement, arc.axisDeg).value()));
  Measurement measurement = withNoise(set, noise);
  measurement.nominalRadius = planned.starts.front().radius;
  for (KnownNumber& known : measurement.known) known.value = 0;
  planned.measurement = std::make_shared<const Measurement>(std::move(measurement));
  for (const EstimatedTerm& term : model.options.terms)
    if (!isOfJump(term.term)) planned.options.terms.push_back(asPlanned(term, model));
  return withEveryEffect(std::move(planned), scales);
}

std::optional<Intersection> intersectionOf(const GapModel& planned) {
  return planned.fit->converged() ? intersect(*planned.measurement, *planned.fit) : std::nullopt;
}

/// Returns the reduction of the variance of Δd by exact knowledge of an effect's parameters, mm²: cᵀ S⁻¹ c. c
/// are their covariances with Δd, S is their covariance matrix.
double varianceUpTo(const GapModel& planned, const Effect& effect) {
  const JointFit& fit = *planned.fit;
  const std::vector<double> weights =
      intersectionWeights(fit, *arcAt(*planned.measurement, 0), *arcAt(*planned.measurement, 180));
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
    if (fit.unknowns[i].kind == Unknown::Kind::Error &&
        effectOf(fit.unknowns[i].term, *planned.measurement) == &effect)
      own.push_back(i);
  if (own.empty()) return 0;
  const auto count = static_cast<Eigen::Index>(own.size());
  Eigen::MatrixXd among(count, count);
  Eigen::VectorXd withIntersection(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t row = own[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < count; ++j)
      among(i, j) = fit.cofactor(row, own[static_cast<std::size_t>(j)]);
    withIntersection[i] = covarianceWith(fit.cofactor, weights, row);
  }
  return std::max(withIntersection.dot(among.ldlt().solve(withIntersection)), 0.0);
}

/// Returns the attainable U for each effect whose certificate is worth the effort (`worthwhileShare`).
std::vector<AttainableUncertainty> withKnownEffects(const GapModel& planned, const Intersection& found) {
  std::vector<AttainableUncertainty> list;
  for (const Effect* effect : effectsOf(*planned.measurement)) {
    const double left = 1 - varianceUpTo(planned, *effect) / square(found.sigma);
    const double expanded = found.expanded * std::sqrt(std::max(left, 0.0));
    if (expanded <= worthwhileShare * found.expanded)
      list.push_back({.measures = {}, .known = std::string(effect->id), .expanded = expanded});
  }
  return list;
}

bool isOneMoreOf(const std::vector<Measure>& some, const std::vector<Measure>& more) {
  return more.size() > some.size() && std::ranges::all_of(some, [&](Measure measure) {
           return std::ranges::find(more, measure) != more.end();
         });
}

/// Whether U is clearly less than the U of the present readings and of every part of the combination.
bool isWorthIt(const AttainableUncertainty& attainable, const std::vector<AttainableUncertainty>& all) {
  return std::ranges::all_of(all, [&](const AttainableUncertainty& other) {
    return !isOneMoreOf(other.measures, attainable.measures) ||
           attainable.expanded <= worthwhileShare * other.expanded;
  });
}

}  // namespace

std::optional<double> attainableAsItIs(const GapModel& model, double noise) {
  if (!hasBothAxes(*model.measurement) || isLarge(*model.measurement)) return std::nullopt;
  const auto found = intersectionOf(plannedModel(model, readWithoutError(model), noise, {}));
  return found ? std::optional(found->expanded) : std::nullopt;
}

std::vector<AttainableUncertainty> attainableUncertainties(const GapModel& model, double noise,
                                                           const EffectScales& scales) {
  if (!hasBothAxes(*model.measurement) || isLarge(*model.measurement)) return {};
  const GapModel planned = plannedModel(model, readWithoutError(model), noise, scales);
  const std::optional<Intersection> asPlanned = intersectionOf(planned);
  if (!asPlanned) return {};
  std::vector<AttainableUncertainty> tried{{{}, {}, asPlanned->expanded}}, list = tried;
  const auto tryOut = [&](const FurtherReadings& plan) {
    if (plan.sets.size() > 1) return;
    if (const auto found = intersectionOf(plannedModel(model, plan.sets.front(), noise, scales)))
      tried.push_back({plan.measures, {}, found->expanded});
  };
  eachFurtherReadings(model, tryOut);
  eachCombination(model, tryOut);
  std::copy_if(tried.begin() + 1, tried.end(), std::back_inserter(list),
               [&](const AttainableUncertainty& attainable) { return isWorthIt(attainable, tried); });
  std::ranges::move(withKnownEffects(planned, *asPlanned), std::back_inserter(list));
  std::stable_sort(
      list.begin() + 1, list.end(),
      [](const AttainableUncertainty& a, const AttainableUncertainty& b) { return a.expanded < b.expanded; });
  return list;
}

}  // namespace alidade
