#pragma once

#include <QUndoCommand>

#include "core/session/session.h"
#include "ui/document/journal_keeper.h"

namespace alidade::ui {

class SessionDocument;

/// Puts another session in place of the present one, all of it at once. Undone, the one before is back.
class ReplaceSession : public QUndoCommand {
 public:
  ReplaceSession(SessionDocument& document, Session session, const QString& text);

  void undo() override;
  void redo() override;

 private:
  SessionDocument& m_document;
  Session m_other;  ///< the one that is not at work
  JournalKeeper::State m_otherState;
};

}  // namespace alidade::ui
