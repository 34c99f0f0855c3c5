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

/// The one session at work: its data, its undo stack and its file. Views read `session()` and listen to
/// `changed`; only commands write. Modified means: the session at work is not as it was last saved or loaded.
/// Undo may lead to another session, in a file of its own: see `SessionFiles`.
class SessionDocument : public QObject {
  Q_OBJECT

 public:
  explicit SessionDocument(QObject* parent = nullptr);

  const Session& session() const { return m_session; }
  QUndoStack& undoStack() { return m_undoStack; }  ///< to look at, undo and redo
  HalfTyped& halfTyped() { return m_halfTyped; }
  const HalfTyped& halfTyped() const { return m_halfTyped; }
  /// Empty for a session never saved.
  QString path() const { return m_files.path(m_undoStack.index()); }
  /// Of all sessions that undo and redo lead to, as far as they are in files.
  QStringList paths() const { return m_files.paths(); }
  /// Files that its parts were taken from: of readings, of an instrument, of a protocol.
  QStringList readPaths() const { return m_readPaths; }
  void noteRead(const QStringList& paths) { m_readPaths += paths; }
  QString displayName() const;  ///< the file's name, or "Untitled"
  bool isModified() const { return m_files.isModified(m_undoStack.index()); }
  /// The path of another session, unsaved, that redo or undo leads to: see `SessionFiles`.
  std::optional<QString> unsavedAhead() const {
    return m_files.unsavedAhead(m_undoStack.index(), m_undoStack.count());
  }
  std::optional<QString> unsavedBehind() const {
    return m_files.unsavedBehind(m_undoStack.index(), m_undoStack.count());
  }

  /// The one way for an edit onto the undo stack. Takes the command over.
  void push(QUndoCommand* command);
  /// Likewise one that puts another session, in no file yet, in place of the present one.
  void pushAnother(QUndoCommand* command);
  /// The edits pushed until `endTogether` are undone in one step.
  void beginTogether(const QString& undoText);
  void endTogether() { m_undoStack.endMacro(); }

  void startNew();
  /// A session that is in no file yet.
  void startWith(Session session);
  /// Likewise, but one whose entries stand: it was in a file before, and changes of it are told.
  void startWithStanding(Session session);
  /// Absent: loaded. A session with entries that mean nothing loads; one that is no session does not, and the
  /// document stays as it was.
  [[nodiscard]] std::optional<Problem> load(const QString& path);
  void startFrom(FiledSession file, const QString& path);
  /// Absent: saved, all of it or nothing (the old file stays where writing fails).
  [[nodiscard]] std::optional<Problem> save(const QString& path);
  /// SHA-256 of the bytes last read from or written to `path()`; empty where there were none.
  QByteArray knownSha256() const { return m_knownSha256.value(path()); }
  /// The session at work is now as in this file, whose bytes have that hash.
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
  friend class ChangeProtocol;
  friend class ImportReadings;
  friend class JournalledCommand;
  friend class RemovePosition;
  friend class ReplaceReadings;
  friend class ReplaceSession;
  friend class SealSession;

  SessionChange told(SessionChange change);  ///< with what it is to the journal
  void putField(const Place& place, const std::string& text);
  void putEffects(const std::vector<std::string>& effects);
  /// `size` in the place of the entry at `place` where that `isThere`, else before it; absent: it goes.
  void putKnown(const Place& place, bool isThere, const std::optional<KnownSize>& size);
  void putInstrument(const Instrument& instrument);
  void patchReadings(std::size_t position, const std::shared_ptr<const ReadingsPatch>& patch);
  void revertReadings(std::size_t position, const std::shared_ptr<const ReadingsPatch>& patch);
  void insertPosition(std::size_t index, const Position& position);
  void removePosition(std::size_t index);
  void exchangeSession(Session& session, JournalKeeper::State& state);  ///< with the one at work
  void exchangeContent(Session& session);                               ///< likewise, but not the journal
  void tellOfJournal();                                                 ///< that it alone has changed
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
