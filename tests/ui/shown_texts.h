#pragma once

#include <QString>
#include <vector>

class QWidget;

namespace alidade::ui {

/// A text that a window shows, and where.
struct ShownText {
  QString where, text;
};

/// Every text of a window and its children, including tool tips and screen reader texts. Excludes entries
/// being edited, which show the typed text.
std::vector<ShownText> shownTexts(QWidget& window);

/// Fails the test for every text with hidden characters, and for every label that might interpret a name as
/// markup.
void expectAllVisible(QWidget& window, const QString& when);

}  // namespace alidade::ui
