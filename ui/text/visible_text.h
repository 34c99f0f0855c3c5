#pragma once

#include <QString>
#include <string>
#include <vector>

namespace alidade::ui {

/// User text made safe for a window or sheet, on one line: characters that reverse or hide text or end the
/// line become their JSON escapes (`alidade::visibleText`).
QString visibleLine(const QString& text);
inline QString visibleLine(const std::string& text) {
  return visibleLine(QString::fromStdString(text));
}

/// As `visibleLine`, but keeps tabs and all line ends.
QString visibleLines(const QString& text);

/// The text on one line of at most `most` characters; an ellipsis replaces the rest.
QString shortLine(const QString& text, int most);
inline QString shortLine(const std::string& text, int most) {
  return shortLine(QString::fromStdString(text), most);
}

/// The sentences, each on its own line, with an empty line between them.
QString paragraphs(const std::vector<std::string>& sentences);

/// Text for a menu, tab or button: short, with ampersands escaped, since they would underline a letter.
QString menuText(const QString& text);

/// Text for a tool tip, broken into lines; an ellipsis replaces lines that would not fit a screen.
QString tipText(const QString& text);

}  // namespace alidade::ui
