#include "core/simulation/truth.h"

#include "core/base/random_source.h"
#include "core/effects/catalogue.h"

namespace alidade {

namespace {

double unitOf(ErrorTerm term, const OwnEffects* own) {
  for (const Effect* effect : effectsWith(own))
    for (const EffectParameter& parameter : effect->parameters)
      if (parameter.term == term) return modelUnitsPer(parameter.unit);
  return 1;
}

}  // namespace

Truth drawTruth(std::uint64_t seed) {
  // A separate stream from that of the readings.
  constexpr std::uint64_t stream = 1;
  RandomSource random(seed, stream);
  Truth truth;
  truth.seed = seed;
  truth.centreX = random.uniform(-2, 2);
  truth.axisHeight = random.uniform(-2, 2);
  truth.intersection = random.uniform(-3, 3);
  truth.radius += 0.15 * random.normal();
  truth.horizontalZero = Angle::fromDegrees(random.uniform(0, 360));
  return truth;
}

ErrorTerms<double> errorsOf(const Truth& truth) {
  ErrorTerms<double> errors;
  for (const TrueSize& size : truth.effects)
    errors.set(size.term, size.value * unitOf(size.term, truth.own.get()));
  return errors;
}

}  // namespace alidade
