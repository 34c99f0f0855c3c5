#include "ui/commands/reading_block.h"

#include <QRegularExpression>
#include <algorithm>

namespace alidade::ui {

namespace {

QString unquoted(const QString& cell) {
  const QString trimmed = cell.trimmed();
  const QChar quote = QLatin1Char('"');
  if (trimmed.size() < 2 || !trimmed.startsWith(quote) || !trimmed.endsWith(quote)) return trimmed;
  QString inner = trimmed.mid(1, trimmed.size() - 2);
  const QString doubled = QStringLiteral("\"\"");
  if (QString(inner).remove(doubled).contains(quote)) return trimmed;
  return inner.replace(doubled, QString(quote)).trimmed();
}

bool isEmptyRow(const QStringList& row) {
  return std::all_of(row.begin(), row.end(), [](const QString& cell) { return cell.isEmpty(); });
}

}  // namespace

ReadingBlock parseBlock(const QString& text) {
  static const QRegularExpression lineEnd(QStringLiteral("\r\n|\r|\n"));
  const QChar separator = text.contains(QLatin1Char('\t')) ? QLatin1Char('\t') : QLatin1Char(';');
  ReadingBlock block;
  for (const QString& line : text.split(lineEnd)) {
    QStringList row;
    for (const QString& cell : line.split(separator)) row.append(unquoted(cell));
    block.append(row);
  }
  while (!block.isEmpty() && isEmptyRow(block.last())) block.removeLast();
  return block;
}

QString blockText(const ReadingBlock& block) {
  static const QRegularExpression breaks(QStringLiteral("[\t\r\n]+"));
  const auto isBreak = [](QChar c) { return c == u'\t' || c == u'\r' || c == u'\n'; };
  QStringList lines;
  for (const QStringList& row : block) {
    QStringList cells;
    for (QString cell : row) {
      if (std::any_of(cell.cbegin(), cell.cend(), isBreak)) cell.replace(breaks, QStringLiteral(" "));
      cells.append(cell);
    }
    lines.append(cells.join(QLatin1Char('\t')));
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace alidade::ui
