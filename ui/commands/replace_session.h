#pragma once

#include "ui/commands/journalled_command.h"
#include "ui/document/journal_keeper.h"

namespace alidade::ui {

/// Replaces the whole session by another. Undo restores the previous one.
class ReplaceSession : public SessionCommand {
 public:
  ReplaceSession(SessionDocument& document, Session session, const QString& text);

  void undo() override { exchange(); }
  void redo() override { exchange(); }

 private:
  void exchange();

  Session m_other;  ///< the session not in use
  JournalKeeper::State m_otherState;
};

}  // namespace alidade::ui
