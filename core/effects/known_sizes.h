#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/effects/catalogue.h"
#include "core/session/measurement.h"

namespace alidade {

/// Can it be known by a size? The other relation of the vertical circle cannot: it is there or not.
bool hasSizes(const Effect& effect);

/// The number of the catalogue that is meant, by effect, name where the effect has two (else it may be
/// empty), and unit. Null where there is none.
const EffectParameter* parameterMeant(std::string_view effect, std::string_view parameter,
                                      std::string_view unit);
const EffectParameter* parameterMeant(const KnownNumber& known);

/// What is known beforehand of a number of the catalogue, in the unit of its term: rad, mm or 1. With the
/// chance 1 − p it is normal about the value with this σ; with the chance p, that what is known holds no
/// longer, it has changed since by anything plausible: normal about the value with √(σ² + plausible²).
struct KnownPrior {
  double value = 0, sigma = 0;
  std::string from = {};   ///< of each that says something, "; " between
  std::string date = {};   ///< the latest
  double staleChance = 0;  ///< p: of several, as likely as the likeliest
};

/// All that a session knows of it, weighed by σ⁻²; absent where it knows nothing.
std::optional<KnownPrior> knownOf(const Measurement& measurement, const EffectParameter& parameter);

/// What is known of each number of an effect; absent unless something is of all of them.
std::optional<std::vector<KnownPrior>> knownOf(const Measurement& measurement, const Effect& effect);

/// Chance that what is known of an effect holds no longer; 0 where nothing is.
double staleChanceOf(const Measurement& measurement, const Effect& effect);

/// Is anything known of any number of the catalogue?
bool isAnythingKnown(const Measurement& measurement);

}  // namespace alidade
