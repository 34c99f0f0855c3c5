#pragma once

#include <optional>
#include <string>

#include "core/base/angle.h"

namespace alidade {

/// One sighting as sent by an instrument. Texts are as in a session: angles in a notation of `parseAngle`
/// with the digits of the instrument, empty if it did not send them.
struct InstrumentReading {
  std::string horizontal, vertical;  ///< circle readings, the vertical one in the session's kind of circle
  Angle horizontalAngle, verticalAngle;  ///< the same as numbers
  int face = 1;                          ///< from the vertical circle
  std::string tiltCrossArcsec;           ///< of the standing axis across the line of sight, as read by the
                                         ///< compensator
  std::string tiltLengthArcsec;          ///< the same along the line of sight
  /// The corrections that the instrument has already applied to the angles: words of `inclination
  /// standing_axis collimation tilting_axis` separated by blanks, or `none`; empty: unknown.
  std::string corrections;
  std::string accuracyArcsec;  ///< of the angles, as the instrument states it
  std::string returnCode;      ///< GeoCOM return code received with the angles; empty: another protocol
  /// The reason why the instrument does not guarantee these angles, as a sentence; empty if it does.
  std::string reservation;
  std::optional<bool> isCompensated = {};  ///< the compensator was on; absent: unknown
  std::string serial;                      ///< of the instrument; empty: unknown
  std::string takenAt;                     ///< time of arrival, ISO 8601 with zone; empty: not yet set
  std::string point;                       ///< point number given by the instrument
};

/// The identity that an instrument states.
struct InstrumentIdentity {
  std::string name, serial, software, temperatureC;
};

}  // namespace alidade
