#pragma once

#include <QUndoCommand>

#include "core/session/session.h"

namespace alidade::ui {

class SessionDocument;

/// Puts another session in place of the present one, all of it at once. Undone, the one before is back, in
/// the file it had. Only the file saved last counts as saved; the other one is asked about, though it may be
/// as in its file.
class ReplaceSession : public QUndoCommand {
 public:
  enum class File {
    Same,  ///< the new session is a further state of the one at work
    None,  ///< it is another one, in no file yet
  };

  ReplaceSession(SessionDocument& document, Session session, File file, const QString& text);

  void undo() override;
  void redo() override;

  /// Where it is undone: the session that it took away again is in no file.
  bool hasTakenBackUnsaved() const { return m_file == File::None && m_otherPath.isEmpty(); }

 private:
  void put(const Session& session);

  SessionDocument& m_document;
  Session m_before, m_after;
  File m_file;
  QString m_otherPath;  ///< with None: of the session that is not at work
};

}  // namespace alidade::ui
