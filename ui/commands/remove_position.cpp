#include "ui/commands/remove_position.h"

#include <QCoreApplication>
#include <iterator>
#include <numeric>
#include <utility>

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

void append(std::vector<JournalEntry>& entries, std::vector<JournalEntry> further) {
  for (JournalEntry& entry : further) {
    entry.why = journal_reasons::deleted;
    entries.push_back(std::move(entry));
  }
}

}  // namespace

RemovePosition::RemovePosition(SessionDocument& document, std::size_t index)
    : JournalledCommand(document, QCoreApplication::translate("RemovePosition", "Delete position %1")
                                      .arg(positionText(document.session(), index))),
      m_index(index),
      m_position(document.session().positions.at(index)) {
  ReadingsPatch patch = withoutRows(m_position.readings);
  m_all = entriesOf(document.session(), index, patch, journal_reasons::deleted,
                    [](std::size_t, ReadingColumn) { return true; });
  std::vector<JournalEntry> entries = journal().judge(index, patch, journal_reasons::deleted);
  const std::pair<const char*, const std::string&> texts[] = {
      {"pointing_zero.horizontal", m_position.zero.horizontal},
      {"pointing_zero.vertical", m_position.zero.vertical},
      {"axis_deg", m_position.axisDeg}};
  for (const auto& [field, text] : texts) {
    const Place place{.position = index, .field = field};
    append(m_all, journal().asStanding(place, text, {}));
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
