#pragma once

#include <QFont>
#include <QStringList>

namespace alidade::ui {

/// `text` on one line, or broken between words onto two lines if it is wider than `width` pixels. An ellipsis
/// shortens the last of at most `most` lines (1 or 2).
QStringList inTwoLines(const QString& text, const QFont& font, double width, int most);

}  // namespace alidade::ui
