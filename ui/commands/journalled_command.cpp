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
    m_undone = reversed(allEntries());
    journal().enter(m_undone);
  } else {
    journal().takeBack(m_entries);
  }
  revert();
}

void JournalledCommand::redo() {
  if (m_undone.empty())
    journal().enter(m_entries);
  else
    journal().takeBack(std::exchange(m_undone, {}));
  apply();
}

}  // namespace alidade::ui
