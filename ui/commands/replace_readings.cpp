#include "ui/commands/replace_readings.h"

#include <utility>

#include "ui/document/journal_entries.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

ReplaceReadings::ReplaceReadings(SessionDocument& document, std::size_t position, ReadingsPatch patch,
                                 const QString& text, const char* why)
    : JournalledCommand(document, text), m_position(position), m_patch(std::move(patch)), m_why(why) {
  setEntries(journal().judge(m_position, m_patch, m_why));
}

void ReplaceReadings::apply() {
  edit(change(false), [this](Session& session) { m_patch.apply(session.positions.at(m_position).readings); });
}
void ReplaceReadings::revert() {
  edit(change(true), [this](Session& session) { m_patch.revert(session.positions.at(m_position).readings); });
}

SessionChange ReplaceReadings::change(bool isReverted) const {
  const RowSpan span = m_patch.span();
  return {.kind = SessionChange::Kind::Readings,
          .place = {.position = m_position, .reading = span.first},
          .removed = isReverted ? span.after : span.before,
          .inserted = isReverted ? span.before : span.after};
}

std::vector<JournalEntry> ReplaceReadings::allEntries() const {
  return entriesOf(document().session(), m_position, m_patch, m_why,
                   [](std::size_t, ReadingColumn) { return true; });
}

void patchReadings(SessionDocument& document, std::size_t position, ReadingsPatch patch, const QString& text,
                   const char* why) {
  if (patch.isEmpty()) return;
  document.push(new ReplaceReadings(document, position, std::move(patch), text, why));
}

void replaceReadings(SessionDocument& document, std::size_t position, std::size_t first, std::size_t removed,
                     const std::vector<Reading>& inserted, const QString& text, const char* why) {
  const std::vector<Reading>& rows = document.session().positions.at(position).readings;
  patchReadings(document, position, ReadingsPatch::replacing(rows, first, removed, inserted), text, why);
}

}  // namespace alidade::ui
