#pragma once

#include <optional>
#include <string>

#include "core/effects/catalogue.h"
#include "core/session/measurement.h"

namespace alidade {

/// The number of the catalogue that is meant, by effect, name where the effect has two, and unit. Null where
/// there is none: the other relation of the vertical circle cannot be known by a size.
const EffectParameter* parameterMeant(const KnownNumber& known);

/// What is known beforehand of a number of the catalogue, in the unit of its term: rad, mm or 1.
struct KnownPrior {
  double value = 0, sigma = 0;
  std::string from;  ///< of each that says something, "; " between
};

/// All that a session knows of it, weighed by σ⁻²; absent where it knows nothing.
std::optional<KnownPrior> knownOf(const Measurement& measurement, const EffectParameter& parameter);

}  // namespace alidade
