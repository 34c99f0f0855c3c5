#pragma once

#include <QUndoCommand>

#include "core/session/session.h"
#include "ui/document/journal_keeper.h"

namespace alidade::ui {

class SessionDocument;

/// Replaces the whole session by another. Undo restores the previous one.
class ReplaceSession : public QUndoCommand {
 public:
  ReplaceSession(SessionDocument& document, Session session, const QString& text);

  void undo() override;
  void redo() override;

 private:
  SessionDocument& m_document;
  Session m_other;  ///< the session not in use
  JournalKeeper::State m_otherState;
};

}  // namespace alidade::ui
