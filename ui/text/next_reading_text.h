#pragma once

#include <QString>

#include "core/base/angle_text.h"
#include "core/evaluation/next_reading.h"
#include "core/session/entry_to_come.h"

namespace alidade {
struct Evaluation;
}  // namespace alidade

namespace alidade::ui {

/// The angle, fine enough for pointing, too coarse to copy as a reading: "341°52′", "341.87°", "379.86 gon".
QString coarseAngleText(Angle angle, CircleUnit unit);

/// The name of a sighting: "Point 7", "Point 7, round 2", "Point 7, round 2, face 2".
QString sightingText(const Reading& sighting);

/// The next entry to type for a user at `position`; absent if no entry is missing, or if the session has more
/// than 10 000 rows (`nextReadings`).
std::optional<EntryToCome> entryToCome(const Evaluation& evaluation, std::size_t position);

/// The entry to which the window leads a user at `position` (`alidade::entryToLeadTo`).
std::optional<EntryToCome> entryToLeadTo(const Evaluation& evaluation, std::size_t position);

/// The reading expected for `entry`; absent if none is known.
std::optional<ExpectedReading> expectedOf(const Evaluation& evaluation, const EntryToCome& entry);

/// The name of the entry: "0°: point 7, round 2", "180°: pointing zero", "Distance".
QString entryText(const Session& session, const EntryToCome& entry);

/// As `nextReadingText` for a row of `position`; else "Next: 180°: pointing zero", "All readings are taken".
QString nextEntryText(const Evaluation& evaluation, std::size_t position);

/// "Next: point 7, round 2, about 341°52′ and 88°17′"; without the angles if none are expected.
QString nextReadingText(const NextReading& next, CircleUnit unit);

}  // namespace alidade::ui
