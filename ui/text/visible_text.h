#pragma once

#include <QString>
#include <string>

namespace alidade::ui {

/// What somebody wrote, as a window or a sheet may show it, on one line: what turns or hides text or ends the
/// line stands there as its JSON escape (`alidade::visibleText`).
QString visibleLine(const QString& text);
inline QString visibleLine(const std::string& text) {
  return visibleLine(QString::fromStdString(text));
}

/// The same with its line ends, of whichever kind, and its tabs.
QString visibleLines(const QString& text);

/// One line of at most `most` characters, the rest an ellipsis.
QString shortLine(const QString& text, int most);
inline QString shortLine(const std::string& text, int most) {
  return shortLine(QString::fromStdString(text), most);
}

/// For a menu, a tab or a button, where an ampersand would underline a letter: short, with ampersands that
/// are seen.
QString menuText(const QString& text);

/// For a tool tip: in lines that fit a screen, and no more of them than do.
QString tipText(const QString& text);

}  // namespace alidade::ui
