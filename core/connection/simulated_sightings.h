#pragma once

#include <cstdint>
#include <vector>

#include "core/base/angle.h"
#include "core/session/session.h"

namespace alidade {

/// What a simulated instrument points at: circle readings as one with a zenith circle has them.
struct SimulatedSighting {
  Angle horizontal, zenith;  ///< in [0°, 360°)
  Angle tiltCross = {}, tiltLength = {};
};

/// The sightings of a session in the order taken: of each position its pointing zero before the readings, in
/// face 1 and in face 2, then its rows, then the zero after them likewise. Zeros that were not sighted and
/// rows whose circles cannot be read are left out. `noise`: σ of what is added to each, drawn from
/// `seed`.
std::vector<SimulatedSighting> sightingsOf(const Session& session, Angle noise = {}, std::uint64_t seed = 1);

}  // namespace alidade
