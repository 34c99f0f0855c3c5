#pragma once

#include <QString>

namespace alidade::ui {

/// What a screen reader says in a cell: its text, or that the column named `title` is empty there.
QString accessibleCell(const QString& shown, const QString& title);

}  // namespace alidade::ui
