#pragma once

#include <QString>
#include <QUndoCommand>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/session/journal.h"
#include "core/session/session.h"
#include "ui/document/session_change.h"

namespace alidade::ui {

class JournalKeeper;
class SessionDocument;

/// A command that writes to the session of a document.
class SessionCommand : public QUndoCommand {
 protected:
  SessionCommand(SessionDocument& document, const QString& text) : m_document(document) { setText(text); }

  void edit(const SessionChange& change, const std::function<void(Session&)>& write);
  JournalKeeper& journal() const;
  SessionDocument& document() const { return m_document; }

 private:
  SessionDocument& m_document;
};

/// An edit of the session that enters the journal if it changes recorded entries. Undo before saving removes
/// the edit from the journal; after undo of a saved edit, the journal lists the edit and its undo.
class JournalledCommand : public SessionCommand {
 public:
  void undo() final;
  void redo() final;

 protected:
  JournalledCommand(SessionDocument& document, const QString& text);

  virtual void apply() = 0;
  virtual void revert() { apply(); }  ///< `apply` suffices for an edit that exchanges two values
  void insertPosition(std::size_t index, const Position& position);
  void erasePosition(std::size_t index);
  /// Journal entries this edit would produce if all its values had been recorded.
  virtual std::vector<JournalEntry> allEntries() const = 0;

  /// Every constructor of a derived class must call `setEntries`.
  void setEntries(std::vector<JournalEntry> entries) { m_entries = std::move(entries); }

 private:
  int m_index;                                     ///< index on the undo stack
  std::vector<JournalEntry> m_entries;             ///< entries that `redo` moves into the journal
  std::size_t m_entered = 0, m_enteredByUndo = 0;  ///< numbers of entries added by the edit and by its undo
};

}  // namespace alidade::ui
