#pragma once

#include <optional>
#include <string>

#include "core/base/angle.h"

namespace alidade {

/// One sighting as sent by an instrument. Texts are as in a session: angles in a notation of `parseAngle`
/// with the digits of the instrument. A text that the instrument did not send is empty.
struct InstrumentReading {
  std::string horizontal, vertical;  ///< circle readings, the vertical one in the session's kind of circle
  Angle horizontalAngle, verticalAngle;  ///< both circle readings as numbers
  int face = 1;                          ///< 1 or 2, by the vertical circle
  std::string tiltCrossArcsec;           ///< compensator reading across the line of sight
  std::string tiltLengthArcsec;          ///< compensator reading along the line of sight
  /// The corrections that the instrument has already applied to the angles: words of `inclination
  /// standing_axis collimation tilting_axis` separated by blanks, or `none`; empty: unknown.
  std::string corrections;
  std::string accuracyArcsec;  ///< accuracy of the angles, stated by the instrument
  std::string returnCode;      ///< GeoCOM return code received with the angles; empty: another protocol
  /// The reason why the instrument does not guarantee these angles, as a sentence; empty if it does.
  std::string reservation;
  std::optional<bool> isCompensated = {};  ///< the compensator was on; absent: unknown
  std::string serial;                      ///< serial number of the instrument; empty: unknown
  std::string takenAt;                     ///< time of arrival, ISO 8601 with zone; empty: not yet set
  std::string point;                       ///< point number stated by the instrument
};

/// The identity that an instrument states.
struct InstrumentIdentity {
  std::string name, serial, software, temperatureC;
};

}  // namespace alidade
