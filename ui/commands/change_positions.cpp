#include "ui/commands/change_positions.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

#include "core/session/entry.h"
#include "core/session/protocol_progress.h"
#include "ui/document/journal_entries.h"
#include "ui/document/session_document.h"
#include "ui/text/position_text.h"

namespace alidade::ui {

namespace {

ReadingsPatch withoutRows(const std::vector<Reading>& rows) {
  std::vector<std::size_t> all(rows.size());
  std::iota(all.begin(), all.end(), 0);
  return ReadingsPatch::removing(rows, all);
}

/// The typed readings of the position's zero and its axis, each with its field.
std::vector<std::pair<std::string, std::string>> textsOf(const Position& position) {
  std::vector<std::pair<std::string, std::string>> texts;
  const auto addZero = [&texts](const std::string& field, const auto& sighting) {
    if (!sighting.horizontal.empty()) texts.emplace_back(field + ".horizontal", sighting.horizontal);
    if (!sighting.vertical.empty()) texts.emplace_back(field + ".vertical", sighting.vertical);
  };
  addZero("pointing_zero", position.zero);
  for (const ZeroSlot& slot : furtherZeros) addZero(zeroField(slot), position.zero.*slot.sighting);
  texts.emplace_back("axis_deg", position.axisDeg);
  return texts;
}

void append(std::vector<JournalEntry>& entries, std::vector<JournalEntry> further) {
  for (JournalEntry& entry : further) {
    entry.why = journal_reasons::deleted;
    entries.push_back(std::move(entry));
  }
}

}  // namespace

AddPosition::AddPosition(SessionDocument& document, int axisDeg)
    : JournalledCommand(document, addPositionText(document.session(), axisDeg)),
      m_index(axisDeg == 0 && !hasPosition(document.session(), 0) ? 0 : document.session().positions.size()) {
  m_position.axisDeg = std::to_string(axisDeg);
  setEntries(journal().judge(place(), {}, m_position.axisDeg));
}

void AddPosition::apply() {
  insertPosition(m_index, m_position);
}
void AddPosition::revert() {
  erasePosition(m_index);
}

Place AddPosition::place() const {
  return {.position = m_index};
}

std::vector<JournalEntry> AddPosition::allEntries() const {
  return journal().asRecorded(place(), {}, m_position.axisDeg);
}

bool hasPosition(const Session& session, int axisDeg) {
  return std::any_of(session.positions.begin(), session.positions.end(), [axisDeg](const Position& position) {
    const Result<int> axis = axisEntry(position.axisDeg);
    return axis && *axis == axisDeg;
  });
}

bool mayAddPosition(const Session& session, int axisDeg) {
  return !hasPosition(session, axisDeg) || hasPosition(session, axisDeg == 0 ? 180 : 0);
}

QString addPositionText(const Session& session, int axisDeg) {
  const QString text = hasPosition(session, axisDeg)
                           ? QCoreApplication::translate("AddPosition", "Measure %1° again")
                           : QCoreApplication::translate("AddPosition", "Add position at %1°");
  return text.arg(axisDeg);
}

void addPosition(SessionDocument& document, int axisDeg) {
  if (!mayAddPosition(document.session(), axisDeg)) return;
  document.push(new AddPosition(document, axisDeg));
}

std::size_t typedSightings(const Position& position) {
  const auto isTyped = [](const auto& sighting) {
    return !sighting.horizontal.empty() || !sighting.vertical.empty();
  };
  auto typed = std::ranges::count_if(position.readings,
                                     [&](const Reading& row) { return isTyped(row) || !row.slider.empty(); });
  if (isTyped(position.zero)) ++typed;
  for (const ZeroSlot& slot : furtherZeros)
    if (isTyped(position.zero.*slot.sighting)) ++typed;
  return static_cast<std::size_t>(typed);
}

RemovePosition::RemovePosition(SessionDocument& document, std::size_t index)
    : JournalledCommand(document, QCoreApplication::translate("RemovePosition", "Delete position %1")
                                      .arg(positionText(document.session(), index))),
      m_index(index),
      m_position(document.session().positions.at(index)) {
  ReadingsPatch patch = withoutRows(m_position.readings);
  m_all = entriesOf(document.session(), index, patch, journal_reasons::deleted,
                    [](std::size_t, ReadingColumn) { return true; });
  std::vector<JournalEntry> entries = journal().judge(index, patch, journal_reasons::deleted);
  for (const auto& [field, text] : textsOf(m_position)) {
    const Place place{.position = index, .field = field};
    append(m_all, journal().asRecorded(place, text, {}));
    append(entries, journal().judge(place, text, {}));
  }
  setEntries(std::move(entries));
}

void RemovePosition::apply() {
  erasePosition(m_index);
}
void RemovePosition::revert() {
  insertPosition(m_index, m_position);
}

void removePosition(SessionDocument& document, std::size_t index) {
  if (index >= document.session().positions.size()) return;
  document.push(new RemovePosition(document, index));
}

}  // namespace alidade::ui
