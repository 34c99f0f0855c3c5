#pragma once

#include <QHash>
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/problem.h"
#include "core/session/session.h"
#include "ui/document/filed_session.h"
#include "ui/document/half_typed.h"
#include "ui/document/journal_keeper.h"
#include "ui/document/session_change.h"
#include "ui/document/session_files.h"

namespace alidade::ui {

/// The current session: its data, its undo stack and its file. Views read `session()` and observe `changed`;
/// only commands write. Modified means different from the last saved or loaded state. Undo may lead to
/// another session with its own file: see `SessionFiles`.
class SessionDocument : public QObject {
  Q_OBJECT

 public:
  explicit SessionDocument(QObject* parent = nullptr);

  const Session& session() const { return m_session; }
  QUndoStack& undoStack() { return m_undoStack; }  ///< for inspection, undo and redo
  HalfTyped& halfTyped() { return m_halfTyped; }
  const HalfTyped& halfTyped() const { return m_halfTyped; }
  /// Empty for a session never saved.
  QString path() const { return m_files.path(m_undoStack.index()); }
  /// The files of all sessions that undo and redo lead to.
  QStringList paths() const { return m_files.paths(); }
  /// Files from which its parts were read: readings, instrument, protocol.
  QStringList readPaths() const { return m_readPaths; }
  void noteRead(const QStringList& paths) { m_readPaths += paths; }
  QString displayName() const;  ///< the file's name, or "Untitled"
  bool isModified() const { return m_files.isModified(m_undoStack.index()); }
  /// The path of another, unsaved session that redo or undo leads to: see `SessionFiles`.
  std::optional<QString> unsavedAhead() const {
    return m_files.unsavedAhead(m_undoStack.index(), m_undoStack.count());
  }
  std::optional<QString> unsavedBehind() const {
    return m_files.unsavedBehind(m_undoStack.index(), m_undoStack.count());
  }

  /// The only way of an edit onto the undo stack. Takes ownership of the command.
  void push(QUndoCommand* command);
  /// Likewise for a command that replaces the present session by an unsaved one.
  void pushAnother(QUndoCommand* command);
  /// Edits pushed until `endTogether` form one undo step.
  void beginTogether(const QString& undoText);
  void endTogether() { m_undoStack.endMacro(); }

  void startNew();
  /// Starts with an unsaved session.
  void startWith(Session session);
  /// Likewise with recorded entries: the session was in a file before, and its changes enter the journal.
  void startWithStanding(Session session);
  /// Absent: loaded. A session with invalid entries loads; if the file is not a session, the document stays
  /// unchanged.
  [[nodiscard]] std::optional<Problem> load(const QString& path);
  void startFrom(FiledSession file, const QString& path);
  /// Absent: saved completely. If writing fails, the old file remains.
  [[nodiscard]] std::optional<Problem> save(const QString& path);
  /// SHA-256 of the bytes last read from or written to `path()`; empty if there were none.
  QByteArray knownSha256() const { return m_knownSha256.value(path()); }
  /// The current session now equals this file, whose bytes have that hash.
  void markSaved(const QString& path, const QByteArray& sha256);

 signals:
  void aboutToChange(const alidade::ui::SessionChange& change);
  void changed(const alidade::ui::SessionChange& change);
  void identityChanged();  ///< path or modified state

 private:
  friend class AddPosition;
  friend class ChangeEffects;
  friend class ChangeField;
  friend class ChangeInstrument;
  friend class ChangeKnown;
  friend class ChangeOwnEffects;
  friend class ChangeProtocol;
  friend class ImportReadings;
  friend class JournalledCommand;
  friend class RemovePosition;
  friend class ReplaceReadings;
  friend class ReplaceSession;
  friend class SealSession;

  SessionChange told(SessionChange change);  ///< adds the change's effect on the journal
  void putField(const Place& place, const std::string& text);
  void putEffects(const std::vector<std::string>& effects);
  void putOwnEffects(const std::vector<OwnEffect>& effects);
  /// Replaces the entry at `place` by `size` if `isThere`, else inserts it before; absent: removes the entry.
  void putKnown(const Place& place, bool isThere, const std::optional<KnownSize>& size);
  void putInstrument(const Instrument& instrument);
  void patchReadings(std::size_t position, const std::shared_ptr<const ReadingsPatch>& patch);
  void revertReadings(std::size_t position, const std::shared_ptr<const ReadingsPatch>& patch);
  void insertPosition(std::size_t index, const Position& position);
  void removePosition(std::size_t index);
  void exchangeSession(Session& session, JournalKeeper::State& state);  ///< with the current one
  void exchangeContent(Session& session);                               ///< likewise, except the journal
  void tellOfJournal();  ///< reports that only the journal changed
  void replaceAll(Session session, const QString& path, bool isNew);

  Session m_session;
  QUndoStack m_undoStack;
  HalfTyped m_halfTyped;
  JournalKeeper m_journal{m_session};
  SessionFiles m_files;
  QStringList m_readPaths;
  QHash<QString, QByteArray> m_knownSha256;  ///< by path
};

}  // namespace alidade::ui
