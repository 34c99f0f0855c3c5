#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnosis/own_effect_curve.h"
#include "core/session/measurement.h"

namespace alidade {

/// How visible an amplitude of the user's own effect is in a session. Visibility is the length of the trace
/// that the fit cannot absorb, in σ of the readings.
struct OwnVisibility {
  std::string parameter;
  std::string unit;      ///< "mm" or "arcsec"
  double perUnit = 0;    ///< trace of 1 mm or 1″, σ
  double plausible = 0;  ///< trace of the plausible size, σ
};

/// The check of a user's own effect on a session, before it is used.
struct OwnEffectCheck {
  std::vector<OwnVisibility> parameters = {};
  /// Identifier of the catalogued effect that the own effect repeats; empty: none. At some size, that effect
  /// explains the trace of the own effect at plausible size, up to a rest below 3 σ and 30 % of the trace.
  std::string sameAs = {};
  std::size_t notFinite = 0;  ///< number of values of the formula that are not finite
  std::size_t values = 0;     ///< number of all values
  std::vector<OwnCurve> curves = {};

  /// Whether the fit absorbs a plausible size of every amplitude.
  bool leavesNothing() const;
  /// One sentence for each problem: values that are not finite, an effect without a trace, a repeated effect.
  std::vector<std::string> sentences() const;
};

/// Checks one of the session's own effects, by its id with `ownPrefix`. Absent without this effect or without
/// a fit. Takes a few milliseconds for a session of a hundred rows.
std::optional<OwnEffectCheck> checkOwnEffect(const Measurement& measurement, const std::string& id);

/// Checks an effect that is being typed, instead of the session's own effects. `effect` must be valid.
std::optional<OwnEffectCheck> checkOwnEffect(Measurement measurement, const OwnEffect& effect);

}  // namespace alidade
