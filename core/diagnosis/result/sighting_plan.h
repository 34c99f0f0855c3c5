#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/angle.h"
#include "core/session/measurement.h"
#include "core/session/sighting_minutes.h"

namespace alidade {

/// Time for pointing and for reading both circles, minutes.
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

/// The effort of a session, to which the effort of measures (`effortOf`) is proportional.
struct SessionEffort {
  double rows = 0, minutes = 0;
};

SessionEffort effortOf(const Measurement& measurement, const SightingMinutes& minutes);

/// A planned point of the slider, with its slider coordinate.
struct SightingPlace {
  int point = 0;
  Angle s;
};

/// A candidate for the next sighting. If the axis is turned, the sighting of the new zero is included.
struct NextSighting {
  int axisDeg = 0, point = 0, face = 1, round = 1;
  bool turnsAxis = false;
  double minutes = 0;
  double ofCauses = 0;               ///< Σ √(wᵢ wⱼ)(1 − BCᵢⱼ), see next_sighting.h
  double ofUncertainty = 0;          ///< −ln(U after/U before)
  std::string one = {}, other = {};  ///< the two causes that it separates most; empty: no cause

  /// The reduction of U has the weight 0.1. With a larger weight, the choice favours sightings that reduce U,
  /// and the causes are found later.
  double worth() const { return ofCauses + 0.1 * ofUncertainty; }
  double perMinute() const { return worth() / minutes; }
};

/// The sightings among which the next is chosen: every place in either face, in either position.
struct SightingPlan {
  std::vector<SightingPlace> places;
  std::vector<int> faces = {1, 2};
  bool readsSlider = false;
  std::size_t rows = 1;  ///< rows of the whole planned session; a stated drift refers to its duration
  bool canTurnAxis = true;
  double noise = 1;  ///< ratio of the expected to the stated noise, > 0
  SightingMinutes minutes = {};
};

}  // namespace alidade
