#pragma once

#include <QString>
#include <QUndoCommand>
#include <cstddef>
#include <vector>

#include "core/session/journal.h"

namespace alidade::ui {

class JournalKeeper;
class SessionDocument;

/// An edit of the session that its journal tells of, where it changes what stood. Undone before it was ever
/// saved it leaves no trace; undone after that, the journal tells of both.
class JournalledCommand : public QUndoCommand {
 public:
  void undo() final;
  void redo() final;

 protected:
  JournalledCommand(SessionDocument& document, const QString& text);

  virtual void apply() = 0;
  virtual void revert() = 0;
  /// What the journal would tell of the edit, had all that it changes stood.
  virtual std::vector<JournalEntry> allEntries() const = 0;

  /// To be called by the constructor of each.
  void setEntries(std::vector<JournalEntry> entries) { m_entries = std::move(entries); }
  JournalKeeper& journal() const;
  SessionDocument& document() const { return m_document; }

 private:
  SessionDocument& m_document;
  int m_index;                               ///< on the undo stack
  std::vector<JournalEntry> m_entries;       ///< while it is not done; else they are in the journal alone
  std::size_t m_told = 0, m_toldUndone = 0;  ///< entries in the journal
};

}  // namespace alidade::ui
