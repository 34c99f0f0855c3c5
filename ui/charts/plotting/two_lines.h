#pragma once

#include <QFont>
#include <QStringList>

namespace alidade::ui {

/// `text` on one line or, if it is wider than `width` pixels and `most` is 2, broken between words onto two.
/// An ellipsis shortens a line that is still wider.
QStringList inTwoLines(const QString& text, const QFont& font, double width, int most);

}  // namespace alidade::ui
