#include "core/diagnosis/planned_uncertainty.h"

#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "core/base/statistics.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/observability/attainable.h"

namespace alidade {

namespace {

/// Calls `use` with the final model of a diagnosis of error-free readings.
template <typename Use>
void withPlannedModel(const Measurement& plan, const Use& use) {
  const SessionFit fit = fitSession(plan);
  const auto own = modelOf(plan, fit);
  if (!own) return;
  const GapModel expected = withKnownSizes(*own);
  use(closedModelOf(expected).value_or(expected));
}

}  // namespace

std::optional<double> plannedUncertaintyOfFit(const Measurement& plan, const NoiseScale& noise) {
  const SessionFit fit = fitSession(withNoise(plan, noise.factor));
  if (!fit.intersection) return std::nullopt;
  const Intersection& found = *fit.intersection;
  const DegreesOfFreedom ofNoise = std::isinf(noise.degreesOfFreedom)
                                       ? DegreesOfFreedom::infinite()
                                       : DegreesOfFreedom(fit.joint.degreesOfFreedom);
  return found.sigma * coverageFactor(plan.coverage, effectiveDegreesOfFreedom(
                                                         found.sigma, scaledPart(found.budget), ofNoise));
}

std::optional<double> plannedUncertainty(const Measurement& plan, double noise) {
  std::optional<double> expanded;
  withPlannedModel(plan, [&](const GapModel& model) { expanded = attainableAsItIs(model, noise); });
  return expanded;
}

std::vector<AttainableUncertainty> plannedUncertainties(const Measurement& plan, double noise) {
  std::vector<AttainableUncertainty> attainable;
  withPlannedModel(plan, [&](const GapModel& model) { attainable = attainableUncertainties(model, noise); });
  return attainable;
}

}  // namespace alidade
