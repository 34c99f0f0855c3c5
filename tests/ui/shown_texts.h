#pragma once

#include <QString>
#include <vector>

class QWidget;

namespace alidade::ui {

/// A text that a window shows, and where.
struct ShownText {
  QString where, text;
};

/// Every text of a window and of all in it, tool tips and what a screen reader is told too. The contents of
/// an entry that is being edited are not among them: there stands what was typed.
std::vector<ShownText> shownTexts(QWidget& window);

/// Fails the test for every text with something hidden in it, and for every label that might take a name for
/// markup.
void expectAllVisible(QWidget& window, const QString& when);

}  // namespace alidade::ui
