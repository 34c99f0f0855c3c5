#include "ui/commands/reading_block.h"

#include <QRegularExpression>
#include <algorithm>
#include <string>
#include <utility>

#include "core/exchange/table_layout.h"

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

/// Of a column that says what is excluded: as `ReadingColumn::Used` has it.
QString usedText(const QString& excluded) {
  static const QStringList words = {QStringLiteral("1"), QStringLiteral("yes"), QStringLiteral("true"),
                                    QStringLiteral("x")};
  return words.contains(excluded.toLower()) ? QStringLiteral("0") : QStringLiteral("1");
}

}  // namespace

std::optional<NamedBlock> namedBlock(const ReadingBlock& block) {
  if (block.size() < 2) return std::nullopt;
  std::vector<std::string> names;
  for (const QString& cell : block.first()) names.push_back(cell.toStdString());
  if (!areColumnNames(names)) return std::nullopt;
  NamedBlock named;
  std::vector<std::pair<qsizetype, ColumnName>> taken;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const ColumnName name = columnName(names[i]);
    const RowField* field = name.column ? name.column->field : nullptr;
    const auto column =
        field && field->flag ? ReadingColumn::Used : readingColumn(field ? std::string(field->key) : "");
    const bool isNew =
        field && std::find(named.columns.begin(), named.columns.end(), column) == named.columns.end();
    if (isNew) {
      named.columns.push_back(column);
      taken.emplace_back(static_cast<qsizetype>(i), name);
    } else if (!names[i].empty()) {
      named.unplaced.append(block.first()[static_cast<qsizetype>(i)]);
    }
  }
  if (taken.empty()) return std::nullopt;
  for (const QStringList& cells : block.mid(1)) {
    QStringList row;
    for (const auto& [at, name] : taken) {
      const QString cell = cells.value(at);
      if (name.column->field->flag)
        row.append(usedText(cell));
      else
        row.append(isAngle(*name.column->field)
                       ? QString::fromStdString(withUnit(cell.toStdString(), name.unit))
                       : cell);
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
  while (!block.isEmpty() && isEmptyRow(block.last())) block.removeLast();
  return block;
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

}  // namespace alidade::ui
