#include "ui/commands/edit_readings.h"

#include <QCoreApplication>
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/session/entry.h"
#include "ui/commands/replace_readings.h"
#include "ui/document/reading_column.h"
#include "ui/document/session_document.h"
#include "ui/text/entry_text.h"
#include "ui/text/position_text.h"

namespace alidade::ui {

namespace {

bool meansExcluded(const QString& cell) {
  static const QStringList words = {QStringLiteral("0"), QStringLiteral("no"), QStringLiteral("false"),
                                    QStringLiteral("excluded")};
  return words.contains(cell.toLower());
}

/// The text of a pasted cell in the form of its column.
std::string pastedText(ReadingColumn column, const QString& cell, CircleUnit unit) {
  if (column == ReadingColumn::Used) return meansExcluded(cell) ? "0" : "1";
  return isAngle(column) ? completedAngle(cell.toStdString(), unit) : cell.toStdString();
}

/// A new reading after the reading `last` (null: no reading); `count` readings precede the new one.
Reading readingAfter(const Reading* last, std::size_t count) {
  Reading reading;
  int point = static_cast<int>(count) + 1;
  if (last) {
    const Result<int> number = parseWhole(last->point);
    if (number) point = *number + 1;
    reading.round = last->round;
    reading.face = last->face;
  }
  reading.point = std::to_string(point);
  return reading;
}

bool exists(const Session& session, const Place& place) {
  return place.position && place.reading && *place.position < session.positions.size() &&
         *place.reading < session.positions[*place.position].readings.size();
}

}  // namespace

const std::vector<Reading>& ReadingsEditor::readings() const {
  return m_document.session().positions.at(m_position).readings;
}

QString ReadingsEditor::noun(ReadingColumn column) {
  return QCoreApplication::translate("ReadingColumn", infoOf(column).noun);
}

void ReadingsEditor::setCell(const ReadingCell& cell, const std::string& typed,
                             const std::optional<Reading>& added) {
  const std::string text =
      isAngle(cell.column) ? completedAngle(typed, circleUnitOf(m_document.session())) : typed;
  if (cell.row >= readings().size()) {
    if (text.empty()) return;
    Reading reading =
        added ? *added : followingReading(m_document.session(), m_position, m_document.chosenSighting());
    reading.*readingText(cell.column) = text;
    replaceReadings(m_document, m_position, readings().size(), 0, {reading},
                    tr("Add point %1").arg(qText(reading.point)), journal_reasons::inserted);
    return;
  }
  const QString point = qText(readings()[cell.row].point);
  enterTexts({{cell.row, cell.column, text}},
             point.isEmpty() ? tr("Change %1").arg(noun(cell.column))
                             : tr("Change %1 of point %2").arg(noun(cell.column), point),
             journal_reasons::retyped);
}

void ReadingsEditor::insertBlank(std::size_t row) {
  replaceReadings(m_document, m_position, std::min(row, readings().size()), 0, {Reading{}},
                  tr("Insert reading"), journal_reasons::inserted);
}

void ReadingsEditor::layOut(FurtherRows which) {
  const std::vector<Reading> further = furtherRows(readings(), which);
  if (further.empty()) return;
  replaceReadings(m_document, m_position, readings().size(), 0, further,
                  tr("Add %1 rows").arg(further.size()), journal_reasons::inserted);
}

void ReadingsEditor::remove(const std::vector<std::size_t>& rows) {
  ReadingsPatch patch = ReadingsPatch::removing(readings(), rows);
  const std::size_t count = patch.rowCount();
  patchReadings(m_document, m_position, std::move(patch),
                count == 1 ? tr("Delete reading") : tr("Delete %1 readings").arg(count),
                journal_reasons::deleted);
}

void ReadingsEditor::setExcluded(const std::vector<std::size_t>& rows, bool excluded) {
  std::vector<NewText> texts;
  texts.reserve(rows.size());
  for (const std::size_t row : rows)
    if (row < readings().size() && readings()[row].excluded != excluded)
      texts.push_back({row, ReadingColumn::Used, excluded ? "0" : "1"});
  const QString one = excluded ? tr("Exclude reading") : tr("Use reading");
  const QString many = excluded ? tr("Exclude %1 readings") : tr("Use %1 readings");
  enterTexts(texts, texts.size() == 1 ? one : many.arg(texts.size()),
             excluded ? journal_reasons::excluded : journal_reasons::usedAgain);
}

void ReadingsEditor::addReason(const std::vector<std::size_t>& rows, const std::string& reason) {
  std::vector<NewText> texts;
  for (const std::size_t row : rows) {
    if (row >= readings().size() || !readings()[row].excluded) continue;
    texts.push_back({row, ReadingColumn::Note, noteWith(row, reason)});
  }
  enterTexts(texts, tr("State why excluded"), journal_reasons::excluded);
}

std::string ReadingsEditor::noteWith(std::size_t row, const std::string& reason) const {
  if (row >= readings().size()) return {};
  const std::string& note = readings()[row].note;
  return note.empty() ? reason : note + "; " + reason;
}

void ReadingsEditor::clear(const std::vector<ReadingCell>& cells, bool cut) {
  patchReadings(m_document, m_position, ReadingsPatch::clearing(readings(), cells),
                cut ? tr("Cut") : tr("Clear"), journal_reasons::cleared);
}

std::size_t ReadingsEditor::paste(const ReadingBlock& block, std::size_t row,
                                  const std::vector<ReadingColumn>& columns) {
  const std::vector<Reading>& rows = readings();
  std::vector<NewText> texts;
  std::vector<Reading> appended;
  std::size_t widest = 0;
  row = std::min(row, rows.size());
  const CircleUnit unit = circleUnitOf(m_document.session());
  Reading last = rows.empty() ? Reading{} : rows.back();  // the last row, including texts pasted over it
  for (const QStringList& cells : block) {
    const auto width = static_cast<std::size_t>(cells.size());
    widest = std::max(widest, width);
    const bool isNew = row >= rows.size();
    if (isNew) appended.push_back(readingAfter(row > 0 ? &last : nullptr, row));
    for (std::size_t i = 0; i < std::min(width, columns.size()); ++i) {
      std::string text = pastedText(columns[i], cells[static_cast<qsizetype>(i)], unit);
      if (isNew || row + 1 == rows.size()) enter(isNew ? appended.back() : last, columns[i], text);
      if (!isNew) texts.push_back({row, columns[i], std::move(text)});
    }
    if (isNew) last = appended.back();
    ++row;
  }
  const bool isReadings = block.size() > 1 || widest > 1;
  patchReadings(m_document, m_position, ReadingsPatch(rows, texts, std::move(appended)),
                isReadings ? tr("Paste %1 readings").arg(block.size()) : tr("Paste"),
                journal_reasons::pasted);
  return widest - std::min(widest, columns.size());
}

void ReadingsEditor::enterTexts(const std::vector<NewText>& texts, const QString& undoText, const char* why) {
  patchReadings(m_document, m_position, ReadingsPatch(readings(), texts), undoText, why);
}

void moveRows(SessionDocument& document, std::size_t from, const std::vector<std::size_t>& rows,
              std::size_t to) {
  const auto& positions = document.session().positions;
  if (from == to || from >= positions.size() || to >= positions.size()) return;
  const std::vector<Reading>& source = positions[from].readings;
  std::vector<Reading> moved;
  for (const std::size_t row : rows)
    if (row < source.size()) moved.push_back(source[row]);
  if (moved.empty()) return;
  const QString text = QCoreApplication::translate("MoveRows", "Move %1 readings to %2")
                           .arg(moved.size())
                           .arg(positionText(document.session(), to));
  document.beginTogether(text);
  patchReadings(document, from, ReadingsPatch::removing(source, rows), text, journal_reasons::moved);
  replaceReadings(document, to, positions[to].readings.size(), 0, moved, text, journal_reasons::moved);
  document.endTogether();
}

void applyChanges(SessionDocument& document, const std::vector<CellChange>& changes,
                  const QString& undoText) {
  const Session& session = document.session();
  std::map<std::size_t, std::vector<NewText>> texts;
  for (const CellChange& change : changes)
    if (exists(session, change.where))
      texts[*change.where.position].push_back(
          {*change.where.reading, readingColumn(change.where.field), change.text});
  std::map<std::size_t, ReadingsPatch> patches;
  for (const auto& [position, news] : texts)
    if (ReadingsPatch patch(session.positions[position].readings, news); !patch.isEmpty())
      patches.emplace(position, std::move(patch));
  const bool isMany = patches.size() > 1;
  if (isMany) document.beginTogether(undoText);
  for (auto& [position, patch] : patches)
    patchReadings(document, position, std::move(patch), undoText, journal_reasons::suggestion);
  if (isMany) document.endTogether();
}

}  // namespace alidade::ui
