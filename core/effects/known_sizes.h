#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/effects/catalogue.h"
#include "core/session/measurement.h"

namespace alidade {

/// Can the size of the effect be known? `vertical_angle_relation` has no size: it is present or absent.
bool hasSizes(const Effect& effect);

/// Returns the parameter of the catalogue with this effect, name and unit; null if there is none. The name
/// may be empty if the effect has only one parameter.
const EffectParameter* findParameter(std::string_view effect, std::string_view parameter,
                                     std::string_view unit);
/// The parameter in the catalogue or in the user's own effects of the measurement.
const EffectParameter* findParameter(const Measurement& measurement, const KnownNumber& known);

/// Prior knowledge of a parameter of the catalogue, in the unit of its term: rad, mm or 1. With probability 1
/// − p the parameter is normal about the value with this σ. With probability p the value is outdated and has
/// changed by a plausible amount: normal about the value with √(σ² + plausible²).
struct KnownPrior {
  double value = 0, sigma = 0;
  std::string from = {};   ///< the sources of the values, separated by "; "
  std::string date = {};   ///< the latest date of the values
  double staleChance = 0;  ///< p; the greatest p if there are several values
};

/// The knowledge of a parameter in a session: its known values, weighted by σ⁻². Absent if it has none.
std::optional<KnownPrior> knownOf(const Measurement& measurement, const EffectParameter& parameter);

/// The knowledge of each parameter of an effect; absent unless all are known.
std::optional<std::vector<KnownPrior>> knownOf(const Measurement& measurement, const Effect& effect);

/// Probability that the known size of an effect is outdated; 0 without a known size.
double staleChanceOf(const Measurement& measurement, const Effect& effect);

/// Is any parameter of the catalogue or of the user's own effects known?
bool isAnythingKnown(const Measurement& measurement);

}  // namespace alidade
