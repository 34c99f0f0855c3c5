#pragma once

#include <string>
#include <vector>

#include "core/session/session.h"
#include "ui/commands/journalled_command.h"
#include "ui/document/journal_keeper.h"

namespace alidade::ui {

class SessionDocument;

/// Replaces the whole session by another. Undo restores the previous session. `isNew`: the other session was
/// never in a file, so that its forms are still being filled in.
class ReplaceSession : public SessionCommand {
 public:
  ReplaceSession(SessionDocument& document, Session session, const QString& text, bool isNew = true);

  void undo() override { exchange(); }
  void redo() override { exchange(); }

 private:
  void exchange();

  Session m_other;  ///< session that the next undo or redo makes current
  JournalKeeper::State m_otherState;
};

/// Replaces the current session by a session with imported readings; keeps file and journal. The journal
/// states the origin of the rows.
class ImportReadings : public JournalledCommand {
 public:
  ImportReadings(SessionDocument& document, Session session, std::vector<JournalEntry> origins,
                 const QString& text);

 private:
  void apply() override;
  std::vector<JournalEntry> allEntries() const override { return m_origins; }

  Session m_other;  ///< session that the next undo or redo makes current; its journal is ignored
  std::vector<JournalEntry> m_origins;
};

/// Seals the current session: the journal records who is responsible and the digest, and lists every later
/// edit.
class SealSession : public JournalledCommand {
 public:
  SealSession(SessionDocument& document, const std::string& by);

 private:
  void apply() override;
  std::vector<JournalEntry> allEntries() const override { return {m_entry}; }

  JournalEntry m_entry;
};

}  // namespace alidade::ui
