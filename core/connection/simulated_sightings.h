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

/// The sightings of a session in the order taken: of each position its pointing zero in face 1, then its
/// rows. Rows whose circles cannot be read are left out. `noise`: σ of what is added to each, drawn from
/// `seed`.
std::vector<SimulatedSighting> sightingsOf(const Session& session, Angle noise = {}, std::uint64_t seed = 1);

}  // namespace alidade
