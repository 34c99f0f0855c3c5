#pragma once

#include <QString>

#include "core/base/place.h"
#include "core/session/session.h"

namespace alidade::ui {

/// "row 3 (point 7)"; `row` counts from 0, the text from 1.
QString accessibleRow(std::size_t row, const std::string& point);

/// The common name of a field of a row, such as "vertical reading" of `vertical`, or else its visible name.
QString rowFieldName(const std::string& name);
/// The common name of a field of a position or of the session: "distance L", "model effects", "known size of
/// the instrument"; otherwise its visible name.
QString sessionFieldName(const std::string& name);

/// The common name of a place in a session: "0°, row 3 (point 7), vertical reading", "180° again, pointing
/// zero β0", "distance L". No name of the session file is in it. Rows count from 1. Empty for the session as
/// a whole.
QString accessiblePlace(const Session& session, const Place& place);

/// Returns the text of a cell for a screen reader: its text, or that the column named `title` is empty there.
QString accessibleCell(const QString& shown, const QString& title);

}  // namespace alidade::ui
