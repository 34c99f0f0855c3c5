#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/angle.h"
#include "core/session/measurement.h"

namespace alidade {

/// One sighting of a target in one face, as the circles had it.
struct FaceReading {
  std::size_t station = 0, target = 0;  ///< indices of `CheckReadings`
  std::string round = {};               ///< as the file has it; empty: it does not say
  int face = 1;
  Angle horizontal = {}, vertical = {};
  double distanceM = 0;  ///< along the line of sight; 0: not known

  bool operator==(const FaceReading&) const = default;
};

/// What an instrument is checked with: sightings in the order in which they were taken.
struct CheckReadings {
  std::vector<std::string> stations, targets;
  std::vector<FaceReading> readings;
  VerticalCircle circle = VerticalCircle::Zenith;
  std::string instrumentName, instrumentSerial, measuredOn;  ///< may be empty
  std::vector<std::string> remarks = {};  ///< sentences: what was taken how, and what was not used
};

}  // namespace alidade
