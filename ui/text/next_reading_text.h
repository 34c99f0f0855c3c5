#pragma once

#include <QString>

#include "core/base/circle_unit.h"
#include "ui/jobs/next_reading.h"

namespace alidade::ui {

/// Good enough to point by, and too coarse to be taken for a reading: "341°52′", "341.87°", "379.86 gon".
QString coarseAngleText(Angle angle, CircleUnit unit);

/// "Point 7", "Point 7, round 2", "Point 7, round 2, face 2".
QString sightingText(const Reading& sighting);

/// "Next: point 7, round 2, about 341°52′ and 88°17′"; without the angles where nothing is expected.
QString nextReadingText(const NextReading& next, CircleUnit unit);

}  // namespace alidade::ui
