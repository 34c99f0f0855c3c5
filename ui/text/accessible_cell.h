#pragma once

#include <QString>

namespace alidade::ui {

/// Returns the text of a cell for a screen reader: its text, or that the column named `title` is empty there.
QString accessibleCell(const QString& shown, const QString& title);

}  // namespace alidade::ui
