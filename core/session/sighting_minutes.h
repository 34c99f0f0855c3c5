#pragma once

#include "core/session/json_origin.h"

namespace alidade {

/// Minutes that the steps of a sighting take. The defaults are working values for one observer.
struct SightingMinutes {
  double turningAxis = 6;          ///< the guideway turned to the other position and clamped
  double plungingTelescope = 0.5;  ///< the telescope turned over to the other face
  double drivingSlider = 0.7;      ///< the slider moved to another place
  JsonOrigin origin = {};

  bool operator==(const SightingMinutes&) const = default;
};

}  // namespace alidade
