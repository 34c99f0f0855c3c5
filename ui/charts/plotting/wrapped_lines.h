#pragma once

#include <QFont>
#include <QStringList>

namespace alidade::ui {

/// `text` broken between words onto at most `most` lines of `width` pixels. An ellipsis shortens a line that
/// is still wider.
QStringList wrappedLines(const QString& text, const QFont& font, double width, int most);

}  // namespace alidade::ui
