#pragma once

#include <optional>
#include <string>

#include "core/base/angle.h"

namespace alidade {

/// One sighting as an instrument told it. Texts are as a session has them: angles in a notation of
/// `parseAngle` with the digits of the instrument, empty where it did not say.
struct InstrumentReading {
  std::string horizontal, vertical;  ///< circle readings, the vertical one in the session's kind of circle
  Angle horizontalAngle, verticalAngle;  ///< the same as numbers
  int face = 1;                          ///< from the vertical circle
  std::string tiltCrossArcsec;   ///< of the standing axis across the line of sight, as the compensator saw it
  std::string tiltLengthArcsec;  ///< along it
  /// Which corrections the instrument has taken off the angles already: words out of `inclination
  /// standing_axis collimation tilting_axis` with blanks between, or `none`; empty: it did not say.
  std::string corrections;
  std::string accuracyArcsec;  ///< of the angles, as the instrument states it
  std::string returnCode;      ///< of GeoCOM, that came with the angles; empty: another protocol
  /// Why the instrument does not vouch for these angles, as a sentence; empty: it does.
  std::string reservation;
  std::optional<bool> isCompensated = {};  ///< the compensator was on; absent: it did not say
  std::string serial;                      ///< of the instrument; empty: it did not say
  std::string takenAt;                     ///< when it came, ISO 8601 with zone; empty: nobody looked yet
  std::string point;                       ///< number that the instrument gave the point
};

/// What an instrument says it is.
struct InstrumentIdentity {
  std::string name, serial, software, temperatureC;
};

}  // namespace alidade
