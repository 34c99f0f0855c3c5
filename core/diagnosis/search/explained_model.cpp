#include "core/diagnosis/search/explained_model.h"

#include <cmath>

#include "core/diagnosis/search/pause.h"

namespace alidade {

namespace {

/// Scales the noise until χ²/f is 1. Iterates, because larger noise gives more weight to prior knowledge,
/// which changes χ².
void findNoise(GapModel& model, const GapModel& base) {
  constexpr int mostRounds = 20;
  constexpr double tolerance = 1e-9;
  for (int round = 0; round < mostRounds; ++round) {
    if (!model.fit->isDetermined() || model.fit->degreesOfFreedom <= 0) return;
    const double more = std::sqrt(model.fit->chiSquare / model.fit->degreesOfFreedom);
    if (!(more > 0) || std::abs(more - 1) < tolerance) return;
    model.noise *= more;
    model.measurement =
        std::make_shared<const Measurement>(withNoise(*base.measurement, model.noise / base.noise));
    model.refit();
  }
}

}  // namespace

GapModel modelWith(const GapModel& base, const Explanation& explanation, const Candidates& candidates,
                   const Leftover& leftover) {
  GapModel model{base.measurement, base.starts, base.options, {}, base.noise};
  for (const Part& part : explanation.parts) {
    const Component& component = candidates[part.component];
    component.addTo(model.options, leftover, part.weights, component.widthOfFit(part.width, part.weights));
  }
  addPause(model.options, *base.measurement, explanation, candidates);
  model.refit();
  if (explanation.noisy) findNoise(model, base);
  return model;
}

}  // namespace alidade
