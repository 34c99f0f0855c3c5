#pragma once

#include "core/session/json_origin.h"

namespace alidade {

/// Minutes of the parts of a sighting: working values for one observer, to be replaced by one's own.
struct SightingMinutes {
  double turningAxis = 6;          ///< the guideway turned to the other position and clamped
  double plungingTelescope = 0.5;  ///< to the other face
  double drivingSlider = 0.7;      ///< to another place
  JsonOrigin origin = {};

  bool operator==(const SightingMinutes&) const = default;
};

}  // namespace alidade
