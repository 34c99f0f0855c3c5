#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/angle.h"
#include "core/session/measurement.h"
#include "core/session/sighting_minutes.h"

namespace alidade {

/// Pointing and reading both circles, minutes.
inline constexpr double minutesOfPointing = 0.6;

/// What a sighting requires besides pointing at its place.
struct SightingMoves {
  bool turnsAxis = false, sightsZero = false, plungesTelescope = false, drivesSlider = false;
};

/// Minutes of a sighting.
inline double minutesOf(const SightingMinutes& minutes, const SightingMoves& moves) {
  return minutesOfPointing +
         ((moves.turnsAxis ? minutes.turningAxis : 0) + (moves.sightsZero ? minutesOfPointing : 0)) +
         (moves.plungesTelescope ? minutes.plungingTelescope : 0) +
         (moves.drivesSlider ? minutes.drivingSlider : 0);
}

/// What a session takes; the effort of measures is in proportion to it (`effortOf`).
struct SessionEffort {
  double rows = 0, minutes = 0;
};

SessionEffort effortOf(const Measurement& measurement, const SightingMinutes& minutes);

/// A place of the slider, its coordinate as planned.
struct SightingPlace {
  int point = 0;
  Angle s;
};

/// A sighting that could be next, or several parts of it: a turn to the other position includes its zero.
struct NextSighting {
  int axisDeg = 0, point = 0, face = 1, round = 1;
  bool turnsAxis = false;
  double minutes = 0;
  double ofCauses = 0;               ///< Σ √(wᵢ wⱼ)(1 − BCᵢⱼ)
  double ofUncertainty = 0;          ///< −ln(U after/U before)
  std::string one = {}, other = {};  ///< the two that it separates most; empty: nothing

  double perMinute() const { return (ofCauses + ofUncertainty) / minutes; }
};

/// The sightings among which the next is chosen: every place in either face, in either position.
struct SightingPlan {
  std::vector<SightingPlace> places;
  std::vector<int> faces = {1, 2};
  bool readsSlider = false;
  std::size_t rows = 1;  ///< of the whole session as planned; a drift is stated for its duration
  bool canTurnAxis = true;
  SightingMinutes minutes = {};
};

}  // namespace alidade
