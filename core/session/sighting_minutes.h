#pragma once

#include "core/session/json_origin.h"

namespace alidade {

/// Minutes that the steps of a sighting take. The defaults are working values for one observer.
struct SightingMinutes {
  double turningAxis = 6;          ///< turning the guideway to the other position and clamping it
  double plungingTelescope = 0.5;  ///< turning the telescope over to the other face
  double drivingSlider = 0.7;      ///< moving the slider to another place
  JsonOrigin origin = {};

  bool operator==(const SightingMinutes&) const = default;
};

}  // namespace alidade
