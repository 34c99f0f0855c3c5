#include "ui/document/journal_entries.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/base/problem.h"
#include "core/session/journal_check.h"
#include "core/session/session_fields.h"

namespace alidade::ui {

namespace {

constexpr std::size_t mostEntries = 1000;

class PatchEntries {
 public:
  PatchEntries(const Session& session, std::size_t position, const char* why, const IsRecorded& isRecorded)
      : m_session(session), m_position(position), m_why(why), m_isRecorded(isRecorded) {}

  void addCell(const ReadingsPatch::Cell& cell) {
    if (!m_isRecorded(cell.row, cell.column) || ++m_count > mostEntries) return;
    const auto& rows = m_session.positions.at(m_position).readings;
    JournalEntry entry = of(rows.at(cell.row), cell.row, infoOf(cell.column).field->key);
    const bool isFlag = !readingText(cell.column);
    entry.from = isFlag ? usedText(cell.before) : cell.before;
    entry.to = isFlag ? usedText(cell.after) : cell.after;
    m_entries.push_back(std::move(entry));
  }

  void addRow(const Reading& row, std::size_t index, bool isGone) {
    if (!isRowRecorded(row, isGone ? index : asAdded) || ++m_count > mostEntries) return;
    JournalEntry entry = of(row, index, {});
    (isGone ? entry.from : entry.to) = rowText(row);
    m_entries.push_back(std::move(entry));
  }

  std::vector<JournalEntry> take() {
    if (m_count <= mostEntries) return std::move(m_entries);
    JournalEntry together = of({}, {}, "readings");
    together.from = together.to = std::to_string(m_count) + " entries";
    return {together};
  }

 private:
  /// An empty row is recorded only in a sealed session, since adding or removing it renumbers later rows.
  bool isRowRecorded(const Reading& row, std::size_t index) const {
    const auto isTyped = [&](const RowField& field) { return field.text && !(row.*field.text).empty(); };
    if (std::ranges::none_of(rowFields, isTyped)) return m_isRecorded(asAdded, ReadingColumn::Used);
    return std::ranges::any_of(rowFields, [&](const RowField& field) {
      return isTyped(field) && m_isRecorded(index, readingColumn(std::string(field.key)));
    });
  }

  static std::string usedText(const std::string& text) { return text == "0" ? "excluded" : "used"; }

  JournalEntry of(const Reading& row, std::optional<std::size_t> index, std::string_view field) const {
    JournalEntry entry;
    entry.place = Place{.position = m_position, .reading = index, .field = std::string(field)}.path();
    entry.axis = m_session.positions.at(m_position).axisDeg;
    entry.point = row.point;
    entry.round = row.round;
    entry.face = row.face;
    entry.why = m_why;
    return entry;
  }

  const Session& m_session;
  std::size_t m_position;
  const char* m_why;
  const IsRecorded& m_isRecorded;
  std::size_t m_count = 0;              ///< number of entries, including those not stored
  std::vector<JournalEntry> m_entries;  ///< the first `mostEntries` entries
};

}  // namespace

std::vector<JournalEntry> entriesOf(const Session& session, std::size_t position, const ReadingsPatch& patch,
                                    const char* why, const IsRecorded& isRecorded) {
  PatchEntries entries(session, position, why, isRecorded);
  for (const ReadingsPatch::Cell& cell : patch.cells()) entries.addCell(cell);
  // Removed rows are listed from the last to the first, so that no removal shifts the index of a later entry.
  const auto& gone = patch.gone();
  for (auto row = gone.rbegin(); row != gone.rend(); ++row) entries.addRow(row->reading, row->index, true);
  std::size_t index = patch.addedFirst();
  for (const Reading& row : patch.added()) entries.addRow(row, index++, false);
  return entries.take();
}

JournalEntry entryOf(const Session& session, const Place& field, std::string from, std::string to) {
  JournalEntry entry;
  entry.place = field.path();
  if (field.position && *field.position < session.positions.size())
    entry.axis = session.positions[*field.position].axisDeg;
  entry.from = std::move(from);
  entry.to = std::move(to);
  entry.why = journal_reasons::retyped;
  return entry;
}

std::vector<JournalEntry> reversed(const std::vector<JournalEntry>& entries) {
  std::vector<JournalEntry> back(entries.rbegin(), entries.rend());
  for (JournalEntry& entry : back) {
    std::swap(entry.from, entry.to);
    entry.why = journal_reasons::undone;
    entry.at.clear();
    entry.hash.clear();
  }
  return back;
}

bool isOfMeasurement(const Place& field) {
  const SessionField* own = sessionFieldNamed(field.field);
  return !own || own->isOfMeasurement;
}

}  // namespace alidade::ui
