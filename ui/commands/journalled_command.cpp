#include "ui/commands/journalled_command.h"

#include <utility>

#include "ui/document/journal_entries.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

void SessionCommand::edit(const SessionChange& change, const std::function<void(Session&)>& write) {
  m_document.edit(EditKey(), change, write);
}

JournalKeeper& SessionCommand::journal() const {
  return m_document.journal(EditKey());
}

JournalledCommand::JournalledCommand(SessionDocument& document, const QString& text)
    : SessionCommand(document, text), m_index(document.undoStack().index()) {}

void JournalledCommand::insertPosition(std::size_t index, const Position& position) {
  edit({.kind = SessionChange::Kind::Positions, .place = {.position = index}, .inserted = 1},
       [&](Session& session) {
         session.positions.insert(session.positions.begin() + static_cast<std::ptrdiff_t>(index), position);
       });
}

void JournalledCommand::erasePosition(std::size_t index) {
  edit({.kind = SessionChange::Kind::Positions, .place = {.position = index}, .removed = 1},
       [&](Session& session) {
         session.positions.erase(session.positions.begin() + static_cast<std::ptrdiff_t>(index));
       });
}

void JournalledCommand::undo() {
  if (journal().isFiled(m_index)) {
    std::vector<JournalEntry> undone = reversed(allEntries());
    m_enteredByUndo = undone.size();
    journal().enter(std::move(undone));
  } else {
    m_entries = journal().takeBack(std::exchange(m_entered, 0));
  }
  revert();
}

void JournalledCommand::redo() {
  if (m_enteredByUndo > 0) {
    journal().takeBack(std::exchange(m_enteredByUndo, 0));
  } else {
    m_entered = m_entries.size();
    journal().enter(std::exchange(m_entries, {}));
  }
  apply();
}

}  // namespace alidade::ui
