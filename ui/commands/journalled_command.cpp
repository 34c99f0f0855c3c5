#include "ui/commands/journalled_command.h"

#include <utility>

#include "ui/document/journal_entries.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

JournalledCommand::JournalledCommand(SessionDocument& document, const QString& text)
    : m_document(document), m_index(document.undoStack().index()) {
  setText(text);
}

JournalKeeper& JournalledCommand::journal() const {
  return m_document.m_journal;
}

void JournalledCommand::undo() {
  if (journal().isFiled(m_index)) {
    std::vector<JournalEntry> undone = reversed(allEntries());
    m_toldUndone = undone.size();
    journal().enter(std::move(undone));
  } else {
    m_entries = journal().takeBack(std::exchange(m_told, 0));
  }
  revert();
}

void JournalledCommand::redo() {
  if (m_toldUndone > 0) {
    journal().takeBack(std::exchange(m_toldUndone, 0));
  } else {
    m_told = m_entries.size();
    journal().enter(std::exchange(m_entries, {}));
  }
  apply();
}

}  // namespace alidade::ui
