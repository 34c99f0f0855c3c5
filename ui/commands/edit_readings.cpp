#include "ui/commands/edit_readings.h"

#include <algorithm>
#include <iterator>

#include "core/base/number_text.h"
#include "ui/commands/replace_readings.h"
#include "ui/document/session_document.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

bool meansExcluded(const QString& cell) {
  static const QStringList words = {QStringLiteral("0"), QStringLiteral("no"), QStringLiteral("false"),
                                    QStringLiteral("excluded")};
  return words.contains(cell.toLower());
}

void enter(Reading& reading, ReadingColumn column, const QString& cell) {
  if (column == ReadingColumn::Used) {
    reading.excluded = meansExcluded(cell);
  } else {
    reading.*readingText(column) = cell.toStdString();
  }
}

}  // namespace

const std::vector<Reading>& ReadingsEditor::readings() const {
  return m_document.session().positions.at(m_position).readings;
}

QString ReadingsEditor::noun(ReadingColumn column) {
  const QString nouns[] = {tr("use"),
                           tr("point number"),
                           tr("round"),
                           tr("face"),
                           tr("horizontal reading"),
                           tr("vertical reading"),
                           tr("slider reading"),
                           QString(),
                           QString(),
                           tr("note")};
  return nouns[static_cast<int>(column)];
}

Reading ReadingsEditor::following(const std::vector<Reading>& rows) {
  Reading reading;
  int point = static_cast<int>(rows.size()) + 1;
  if (!rows.empty()) {
    const Result<int> last = parseWhole(rows.back().point);
    if (last) point = *last + 1;
    reading.round = rows.back().round;
    reading.face = rows.back().face;
  }
  reading.point = std::to_string(point);
  return reading;
}

void ReadingsEditor::setCell(const ReadingCell& cell, const std::string& text) {
  if (cell.row >= readings().size()) {
    if (text.empty()) return;
    Reading reading = following(readings());
    reading.*readingText(cell.column) = text;
    replaceReadings(m_document, m_position, readings().size(), 0, {reading},
                    tr("Add point %1").arg(qText(reading.point)));
    return;
  }
  Reading reading = readings()[cell.row];
  const QString point = qText(reading.point);
  reading.*readingText(cell.column) = text;
  replaceReadings(m_document, m_position, cell.row, 1, {reading},
                  point.isEmpty() ? tr("Change %1").arg(noun(cell.column))
                                  : tr("Change %1 of point %2").arg(noun(cell.column), point));
}

void ReadingsEditor::insertBlank(std::size_t row) {
  replaceReadings(m_document, m_position, std::min(row, readings().size()), 0, {Reading{}},
                  tr("Insert reading"));
}

void ReadingsEditor::remove(const std::vector<std::size_t>& rows) {
  std::vector<bool> gone(readings().size());
  for (const std::size_t row : rows) {
    if (row < gone.size()) gone[row] = true;
  }
  const auto count = std::count(gone.begin(), gone.end(), true);
  if (count == 0) return;
  const auto first = static_cast<std::size_t>(std::find(gone.begin(), gone.end(), true) - gone.begin());
  const auto end = static_cast<std::size_t>(gone.rend() - std::find(gone.rbegin(), gone.rend(), true));
  std::vector<Reading> kept;
  for (std::size_t row = first; row < end; ++row) {
    if (!gone[row]) kept.push_back(readings()[row]);
  }
  replaceReadings(m_document, m_position, first, end - first, kept,
                  count == 1 ? tr("Delete reading") : tr("Delete %1 readings").arg(count));
}

void ReadingsEditor::setExcluded(const std::vector<std::size_t>& rows, bool excluded) {
  std::vector<Reading> changed = readings();
  int count = 0;
  for (const std::size_t row : rows) {
    if (row >= changed.size() || changed[row].excluded == excluded) continue;
    changed[row].excluded = excluded;
    ++count;
  }
  const QString one = excluded ? tr("Exclude reading") : tr("Use reading");
  const QString many = excluded ? tr("Exclude %1 readings") : tr("Use %1 readings");
  replaceWith(changed, count == 1 ? one : many.arg(count));
}

void ReadingsEditor::clear(const std::vector<ReadingCell>& cells, bool cut) {
  std::vector<Reading> changed = readings();
  for (const ReadingCell& cell : cells) {
    if (cell.row < changed.size() && readingText(cell.column))
      changed[cell.row].*readingText(cell.column) = {};
  }
  replaceWith(changed, cut ? tr("Cut") : tr("Clear"));
}

std::size_t ReadingsEditor::paste(const ReadingBlock& block, std::size_t row,
                                  const std::vector<ReadingColumn>& columns) {
  std::vector<Reading> changed = readings();
  std::size_t widest = 0;
  row = std::min(row, changed.size());
  for (const QStringList& cells : block) {
    const auto width = static_cast<std::size_t>(cells.size());
    widest = std::max(widest, width);
    if (row >= changed.size()) changed.push_back(following(changed));
    for (std::size_t i = 0; i < std::min(width, columns.size()); ++i) {
      enter(changed[row], columns[i], cells[static_cast<qsizetype>(i)]);
    }
    ++row;
  }
  const bool isReadings = block.size() > 1 || widest > 1;
  replaceWith(changed, isReadings ? tr("Paste %1 readings").arg(block.size()) : tr("Paste"));
  return widest - std::min(widest, columns.size());
}

/// `rows` is as long as the readings or longer. The undo step covers the rows that differ.
void ReadingsEditor::replaceWith(const std::vector<Reading>& rows, const QString& undoText) {
  const std::vector<Reading>& old = readings();
  const auto [oldFirst, newFirst] = std::mismatch(old.begin(), old.end(), rows.begin());
  if (newFirst == rows.end()) return;
  const auto first = static_cast<std::size_t>(newFirst - rows.begin());
  std::size_t oldEnd = old.size(), newEnd = rows.size();
  while (oldEnd == newEnd && oldEnd > first && old[oldEnd - 1] == rows[newEnd - 1]) --oldEnd, --newEnd;
  replaceReadings(m_document, m_position, first, oldEnd - first,
                  {newFirst, std::next(rows.begin(), static_cast<std::ptrdiff_t>(newEnd))}, undoText);
}

}  // namespace alidade::ui
