#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnosis/own_effect_curve.h"
#include "core/session/measurement.h"

namespace alidade {

/// How far an amplitude of an effect of the user's own shows in a session: the length of what the fit cannot
/// take up, in σ of the readings.
struct OwnVisibility {
  std::string parameter;
  std::string unit;      ///< "mm" or "arcsec"
  double perUnit = 0;    ///< σ per mm or arcsecond
  double plausible = 0;  ///< σ of the plausible size
};

/// What a session says of an effect of the user's own before it is used.
struct OwnEffectCheck {
  std::vector<OwnVisibility> parameters = {};
  /// Id of the effect of the catalogue that it is: these readings tell the two apart by less than 3 σ, at
  /// plausible sizes. Empty: none.
  std::string sameAs = {};
  std::size_t notFinite = 0;  ///< values of the formula on these readings that are no finite number
  std::size_t values = 0;     ///< of all
  std::vector<OwnCurve> curves = {};

  /// Of no amplitude a plausible size is beyond what the fit takes up.
  bool leavesNothing() const;
  /// What the user should know, a sentence each: what is not finite, what leaves nothing, what it is already.
  std::vector<std::string> sentences() const;
};

/// Of one of the session's own effects, by its id with `ownPrefix`. Absent if there is no such effect, or no
/// fit. Takes a few milliseconds for a session of a hundred rows.
std::optional<OwnEffectCheck> checkOwnEffect(const Measurement& measurement, const std::string& id);

/// Of an effect that is being typed, in place of the session's own ones. It must be sound.
std::optional<OwnEffectCheck> checkOwnEffect(Measurement measurement, const OwnEffect& effect);

}  // namespace alidade
