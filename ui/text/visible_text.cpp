#include "ui/text/visible_text.h"

#include <QStringList>
#include <algorithm>

#include "core/base/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int longestMenuText = 60, tipWidth = 90;
constexpr qsizetype mostTipLines = 24;

/// True for letters, digits and signs that are always shown unchanged: a fast path for nearly all text.
bool isPlain(QChar c) {
  const char16_t code = c.unicode();
  return (code >= 0x20 && code < 0x7F) || (code >= 0xA0 && code < 0x300 && code != 0xAD) ||
         (code >= 0x370 && code < 0x600) || (code >= 0x2010 && code < 0x2028) ||
         (code >= 0x2030 && code < 0x2060) || (code >= 0x2190 && code < 0x2300);
}

QString visible(const QString& text, std::string_view kept) {
  if (std::all_of(text.begin(), text.end(), isPlain)) return text;
  return QString::fromStdString(visibleText(text.toStdString(), kept));
}

/// Pieces of at most `tipWidth`, split at blanks if possible.
QStringList brokenLines(QString line) {
  QStringList pieces;
  while (line.size() > tipWidth) {
    const auto blank = line.lastIndexOf(u' ', tipWidth);
    const auto end = blank > tipWidth / 2 ? blank : qsizetype{tipWidth};
    const bool splitsCharacter = line.at(end - 1).isHighSurrogate();
    pieces.append(line.left(splitsCharacter ? end - 1 : end));
    line.remove(0, pieces.last().size());
  }
  return pieces << line;
}

}  // namespace

QString visibleLine(const QString& text) {
  return visible(text, {});
}

QString visibleLines(const QString& text) {
  if (!text.contains(u'\r')) return visible(text, "\n\t");
  QString lines = text;
  lines.replace(QStringLiteral("\r\n"), QStringLiteral("\n"));
  return visible(lines, "\n\t");
}

QString shortLine(const QString& text, int most) {
  if (text.size() <= most) return visibleLine(text);
  return QString::fromStdString(shortened(text.toStdString(), static_cast<std::size_t>(most)));
}

QString paragraphs(const std::vector<std::string>& sentences) {
  QStringList lines;
  for (const std::string& sentence : sentences) lines.append(visibleLine(sentence));
  return lines.join(QStringLiteral("\n\n"));
}

QString menuText(const QString& text) {
  return shortLine(text, longestMenuText).replace(u'&', QStringLiteral("&&"));
}

QString tipText(const QString& text) {
  QStringList lines;
  for (const QString& line : visibleLines(text).split(u'\n')) {
    lines += brokenLines(line);
    if (lines.size() <= mostTipLines) continue;
    lines = lines.mid(0, mostTipLines);
    lines.append(QStringLiteral("…"));
    break;
  }
  return lines.join(u'\n');
}

}  // namespace alidade::ui
