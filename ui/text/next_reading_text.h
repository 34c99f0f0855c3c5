#pragma once

#include <QString>

#include "core/base/circle_unit.h"
#include "core/session/entry_to_come.h"
#include "ui/jobs/next_reading.h"

namespace alidade::ui {

struct Evaluation;

/// Good enough to point by, and too coarse to be taken for a reading: "341°52′", "341.87°", "379.86 gon".
QString coarseAngleText(Angle angle, CircleUnit unit);

/// "Point 7", "Point 7, round 2", "Point 7, round 2, face 2".
QString sightingText(const Reading& sighting);

/// What is to be typed next while one types at `position`; absent where nothing is left, and in a session of
/// more rows than anyone types.
std::optional<EntryToCome> entryToCome(const Evaluation& evaluation, std::size_t position);

/// The reading expected there; absent of a zero.
std::optional<ExpectedReading> expectedOf(const Evaluation& evaluation, const EntryToCome& entry);

/// "0°: point 7, round 2", "180°: pointing zero".
QString entryText(const Session& session, const EntryToCome& entry);

/// "Next: 180°: pointing zero"; of a row at `position`, which is in front, as below.
QString nextEntryText(const Evaluation& evaluation, std::size_t position);

/// "Next: point 7, round 2, about 341°52′ and 88°17′"; without the angles where nothing is expected.
QString nextReadingText(const NextReading& next, CircleUnit unit);

}  // namespace alidade::ui
