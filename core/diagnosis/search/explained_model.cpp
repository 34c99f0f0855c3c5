#include "core/diagnosis/search/explained_model.h"

#include <algorithm>
#include <cmath>

#include "core/base/square.h"
#include "core/diagnosis/search/pause.h"

namespace alidade {

namespace {

/// χ²/f without zeros that have a σ of their own: where these contradict each other, no noise explains that.
double scatterOf(const GapModel& model) {
  double chiSquare = model.fit->chiSquare, freedom = model.fit->degreesOfFreedom;
  for (const AdjustedReading& reading : model.fit->readings) {
    const bool isZero = model.measurement->arcs[reading.arc].sightings[reading.sighting].isZero;
    if (!isZero || model.measurement->zerosAreReadings) continue;
    chiSquare -= square(reading.residual / reading.sigma);
    freedom -= reading.redundancy;
  }
  return freedom > 0 ? std::max(chiSquare, 0.0) / freedom : 0;
}

/// Scales the noise until χ²/f is 1, but not below that of `base`. Iterates, because larger noise gives more
/// weight to prior knowledge, which changes χ².
void findNoise(GapModel& model, const GapModel& base) {
  constexpr int mostRounds = 20;
  constexpr double tolerance = 1e-9;
  for (int round = 0; round < mostRounds; ++round) {
    if (!model.fit->isDetermined() || model.fit->degreesOfFreedom <= 0) return;
    const double noise = std::max(model.noise * std::sqrt(scatterOf(model)), base.noise);
    if (std::abs(noise / model.noise - 1) < tolerance) return;
    model.noise = noise;
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
