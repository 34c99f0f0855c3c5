#include "ui/document/journal_keeper.h"

#include <algorithm>
#include <utility>

#include "core/base/clock.h"

namespace alidade::ui {

JournalKeeper::State JournalKeeper::stateOf(const Session& session, bool isNew) {
  State state{.filed = session.journal.size()};
  if (!isNew) state.open.close();
  return state;
}

void JournalKeeper::restart(bool isNew) {
  m_state = stateOf(m_session, isNew);
}

void JournalKeeper::exchange(State& state) {
  std::swap(m_state, state);
  m_state.open.closeRow();
}

void JournalKeeper::setFiled(int undoIndex) {
  m_state.open.close();
  m_state.filed = m_session.journal.size();
  m_state.filedIndex = undoIndex;
}

void JournalKeeper::dropFrom(int undoIndex) {
  m_state.filedIndex = std::min(m_state.filedIndex, undoIndex);
}

std::vector<JournalEntry> JournalKeeper::judge(std::size_t position, ReadingsPatch& patch, const char* why) {
  const std::vector<Reading>& rows = m_session.positions.at(position).readings;
  const auto isRecorded = [&, sealed = isSealed()](std::size_t row, ReadingColumn column) {
    if (sealed) return true;
    if (row >= rows.size() || m_state.open.isOpen(position, row, column)) return false;
    if (column == ReadingColumn::Note) return false;
    const auto text = readingText(column);
    return !text || !(rows[row].*text).empty();
  };
  auto entries = entriesOf(m_session, position, patch, why, isRecorded);
  patch.keepFirstTexts(rows, isRecorded);
  m_state.open.enter(position, rows, patch);
  return entries;
}

std::vector<JournalEntry> JournalKeeper::judge(const Place& field, const std::string& from,
                                               const std::string& to) {
  const bool isRecorded = isSealed() || (!from.empty() && !m_state.open.isOpen(field));
  m_state.open.enter(field, from.empty());
  return isRecorded ? asRecorded(field, from, to) : std::vector<JournalEntry>();
}

std::vector<JournalEntry> JournalKeeper::asRecorded(const Place& field, const std::string& from,
                                                    const std::string& to) const {
  if (!isSealed() && !isOfMeasurement(field)) return {};
  return {entryOf(m_session, field, from, to)};
}

void JournalKeeper::enter(std::vector<JournalEntry> entries) {
  for (JournalEntry& entry : entries) {
    if (entry.at.empty()) entry.at = timeInUtc();  // a redone entry keeps its original time
    if (entry.by.empty()) entry.by = m_session.operatorName;
    enterInJournal(m_session.journal, std::move(entry));
  }
}

std::vector<JournalEntry> JournalKeeper::takeBack(std::size_t count) {
  m_state.open.closeRow();
  auto& journal = m_session.journal;
  const auto first = journal.end() - static_cast<std::ptrdiff_t>(count);
  std::vector<JournalEntry> last(first, journal.end());
  if (journal.size() < m_state.filed + count) {
    enter(reversed(last));
    return {};
  }
  journal.erase(first, journal.end());
  return last;
}

}  // namespace alidade::ui
