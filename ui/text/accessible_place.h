#pragma once

#include <QString>

#include "core/base/problem.h"
#include "core/session/session.h"

namespace alidade::ui {

/// The name of a row: "row 3 (point 7)". `row` counts from 0, the name from 1.
QString accessibleRow(std::size_t row, const std::string& point);

/// The common name of a row's field, such as "vertical reading"; else `name` with hidden characters visible.
QString rowFieldName(const std::string& name);
/// The common name of a field of a position or of the session: "distance L", "model effects", "known value of
/// the instrument"; else `name` with hidden characters made visible.
QString sessionFieldName(const std::string& name);

/// The common name of a place in a session: "0°, row 3 (point 7), vertical reading", "180° again, pointing
/// zero β0", "distance L". Rows count from 1. Empty for the session as a whole.
QString accessiblePlace(const Session& session, const Place& place);

/// Place and problem: "Distance L is empty: …", "0°, row 4 (point 4), vertical reading: “83 99 34” has …".
QString problemText(const Session& session, const Problem& problem);

/// The text of a cell for a screen reader: `shown`, or that the cell in the column `title` is empty.
QString accessibleCell(const QString& shown, const QString& title);

}  // namespace alidade::ui
