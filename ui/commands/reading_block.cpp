#include "ui/commands/reading_block.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"

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

ReadingBlock withoutEmptyEnd(ReadingBlock block) {
  while (!block.isEmpty() && isEmptyRow(block.last())) block.removeLast();
  return block;
}

/// Whether the cells from `first` on are degrees, minutes and seconds of an angle, each as a plain number.
bool isAngleInParts(const QStringList& row, qsizetype first) {
  constexpr double ends[] = {360, 60, 60};
  for (qsizetype part = 0; part < 3; ++part) {
    const Result<double> number = parseNumber(row[first + part].toStdString());
    if (!number || !(*number >= 0) || !(*number < ends[part])) return false;
    if (part < 2 && *number != std::floor(*number)) return false;
  }
  return true;
}

/// Whether both angles of every row stand in three columns each.
bool hasAnglesInParts(const ReadingBlock& block) {
  constexpr qsizetype cells = 6;
  const qsizetype columns = block.isEmpty() ? 0 : block.first().size();
  for (qsizetype first = 0; first + cells <= columns; ++first)
    if (std::all_of(block.begin(), block.end(), [&](const QStringList& row) {
          return row.size() == columns && isAngleInParts(row, first) && isAngleInParts(row, first + 3);
        }))
      return true;
  return false;
}

/// The clipboard's format of `BlockText`, in UTF-8.
constexpr QLatin1String ownCells("application/x-alidade-cells");

/// The text of `ReadingColumn::Used` for a cell of a column that marks excluded rows.
QString usedText(const QString& excluded) {
  static const QStringList words = {QStringLiteral("1"), QStringLiteral("yes"), QStringLiteral("true"),
                                    QStringLiteral("x")};
  return words.contains(excluded.toLower()) ? QStringLiteral("0") : QStringLiteral("1");
}

}  // namespace

std::optional<Result<JoinedTable>> joinedBlock(const ReadingBlock& block) {
  std::vector<TableCells> rows;
  for (const QStringList& cells : block) {
    rows.emplace_back();
    for (const QString& cell : cells) rows.back().push_back(cell.toStdString());
  }
  return joinedTable(rows);
}

std::optional<NamedBlock> namedBlock(const ReadingBlock& block) {
  const auto table = joinedBlock(block);
  NamedBlock named;
  if (!table) {
    if (!hasAnglesInParts(block)) return std::nullopt;
    named.problem = QString::fromStdString(Phrase::of(
        "degrees, minutes and seconds stand in columns of their own; copy a row with their names, too, or "
        "import the table"));
    return named;
  }
  if (!*table) {
    named.problem = QString::fromStdString(table->problem().what);
    return named;
  }
  const JoinedTable& joined = **table;
  for (const std::string& name : joined.unplaced) named.unplaced.append(QString::fromStdString(name));
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < joined.columns.size(); ++i) {
    const RowField* field = joined.columns[i].field;
    if (!field) {
      named.unplaced.append(QString::fromStdString(joined.names[i]));
      continue;
    }
    named.columns.push_back(field->flag ? ReadingColumn::Used : readingColumn(std::string(field->key)));
    taken.push_back(i);
  }
  if (taken.empty()) return std::nullopt;
  for (const TableCells& cells : joined.rows) {
    QStringList row;
    for (const std::size_t i : taken) {
      const QString cell = QString::fromStdString(cells[i]);
      row.append(joined.columns[i].field->flag ? usedText(cell) : cell);
    }
    named.rows.append(row);
  }
  return named;
}

ReadingBlock parseBlock(const QString& text) {
  static const QRegularExpression lineEnd(QStringLiteral("\r\n|\r|\n"));
  const QChar separator = text.contains(QLatin1Char('\t')) ? QLatin1Char('\t') : QLatin1Char(';');
  ReadingBlock block;
  for (const QString& line : text.split(lineEnd)) {
    QStringList row;
    for (const QString& cell : line.split(separator)) row.append(unquoted(cell));
    block.append(row);
  }
  return withoutEmptyEnd(std::move(block));
}

void BlockText::beginRow() {
  if (m_hasRow) m_text.append(QLatin1Char('\n'));
  m_hasRow = true;
  m_hasCell = false;
}

void BlockText::add(const QString& cell) {
  static const QRegularExpression breaks(QStringLiteral("[\t\r\n]+"));
  const auto isBreak = [](QChar c) { return c == u'\t' || c == u'\r' || c == u'\n'; };
  if (m_hasCell) m_text.append(QLatin1Char('\t'));
  m_hasCell = true;
  if (std::any_of(cell.cbegin(), cell.cend(), isBreak))
    m_text.append(QString(cell).replace(breaks, QStringLiteral(" ")));
  else
    m_text.append(cell);
}

QString blockText(const ReadingBlock& block) {
  BlockText text;
  for (const QStringList& row : block) {
    text.beginRow();
    for (const QString& cell : row) text.add(cell);
  }
  return text.text();
}

void copyBlock(const QString& text) {
  auto* data = new QMimeData;
  data->setText(text);
  data->setData(ownCells, text.toUtf8());
  QApplication::clipboard()->setMimeData(data);
}

ReadingBlock clipboardBlock() {
  const QMimeData* data = QApplication::clipboard()->mimeData();
  if (!data || !data->hasFormat(ownCells)) return parseBlock(QApplication::clipboard()->text());
  ReadingBlock block;
  for (const QString& line : QString::fromUtf8(data->data(ownCells)).split(u'\n'))
    block.append(line.split(u'\t'));
  return withoutEmptyEnd(std::move(block));
}

}  // namespace alidade::ui
