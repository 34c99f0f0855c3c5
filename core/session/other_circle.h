#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade {

// Zenith angles decrease upwards and elevations increase, from origins a right angle apart. An error that
// adds to the circle reading therefore has another sign, or another parameter, on the other kind of circle.

/// The parameter and the sign that an error of the vertical circle has on the other kind of circle.
struct OnOtherCircle {
  std::string parameter;
  double sign = 1;
};

/// Absent if the effect does not depend on the kind of circle. Its own inverse. Source: β = 90° − e for
/// zenith angles and β = e for elevations, in the error j + s sin β + c cos β + S sin 2β + C cos 2β.
std::optional<OnOtherCircle> onOtherCircle(std::string_view effect, std::string_view parameter);

/// The known sizes as they are on a circle of the other kind.
std::vector<KnownSize> onOtherCircle(std::vector<KnownSize> known);

/// A measurement with an elevation circle, as a zenith circle would have read it. Unchanged if the circle is
/// one, or if the user's own effects, which may contain its readings, belong to the measurement.
Measurement withZenithCircle(Measurement measurement);

}  // namespace alidade
