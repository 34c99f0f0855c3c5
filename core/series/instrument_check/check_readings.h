#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/angle.h"
#include "core/base/result.h"
#include "core/session/measurement.h"

namespace alidade {

/// The circles that were read. ISO 17123-3 also has a check for each circle alone.
enum class CheckCircles { Both, HorizontalOnly, VerticalOnly };

/// The instrument, and the days of the check. Any member may be empty; the days are year-month-day.
struct CheckIdentity {
  std::string name = {}, serial = {};
  std::string measuredOn = {};
  std::string due = {};  ///< day of the next check
  VerticalCircle circle = VerticalCircle::Zenith;

  bool operator==(const CheckIdentity&) const = default;
};

/// `read`, overridden by `typed`. Fails if a typed day is invalid, or the next check is not after this one.
Result<CheckIdentity> identityOf(const CheckIdentity& typed, const CheckIdentity& read);

/// One sighting of a target in one face, as read from the circles.
struct FaceReading {
  std::size_t station = 0, target = 0;  ///< indices into the lists of `CheckReadings`
  std::string round = {};               ///< as in the file; empty: not stated
  int face = 1;
  Angle horizontal = {}, vertical = {};  ///< 0 for a circle that was not read
  double distanceM = 0;                  ///< along the line of sight; 0: unknown
  std::size_t file = 0, line = 0;        ///< `file`: index of `CheckReadings::files`; `line` from 1, 0: none

  bool operator==(const FaceReading&) const = default;
};

/// The readings of an instrument check, in the order in which they were taken.
struct CheckReadings {
  std::vector<std::string> stations, targets;
  std::vector<FaceReading> readings;
  std::vector<std::string> files = {};  ///< names for sentences; empty for a single file
  VerticalCircle circle = VerticalCircle::Zenith;
  CheckCircles circles = CheckCircles::Both;
  CheckIdentity identity = {};            ///< as the files state it
  std::vector<std::string> remarks = {};  ///< sentences on assumptions and on what was not used
};

}  // namespace alidade
