#pragma once

#include <cstdint>
#include <vector>

#include "core/base/angle.h"
#include "core/session/session.h"

namespace alidade {

/// A target of a simulated instrument: circle readings with a zenith circle.
struct SimulatedSighting {
  Angle horizontal, zenith;  ///< circle readings in [0°, 360°)
  Angle tiltCross = {}, tiltLength = {};
};

/// The sightings of a session in the order taken: for each position its pointing zero before the readings, in
/// face 1 and in face 2, then its rows, then the zero after the rows, in both faces. Missing zeros and rows
/// with invalid circle readings are left out. `noise`: σ of the normal noise in both circles, from `seed`.
std::vector<SimulatedSighting> sightingsOf(const Session& session, Angle noise = {}, std::uint64_t seed = 1);

}  // namespace alidade
