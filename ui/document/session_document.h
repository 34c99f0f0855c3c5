#pragma once

#include <QHash>
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <cstddef>
#include <functional>
#include <optional>

#include "core/base/problem.h"
#include "core/session/session.h"
#include "ui/document/filed_session.h"
#include "ui/document/half_typed.h"
#include "ui/document/journal_keeper.h"
#include "ui/document/session_change.h"
#include "ui/document/session_files.h"

namespace alidade::ui {

/// The permission to write to the session; only commands can create one.
class EditKey {
  friend class SessionCommand;
  EditKey() = default;
};

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
  /// Empty if the session was never saved.
  QString path() const { return m_files.path(m_undoStack.index()); }
  /// The files of all sessions that undo and redo lead to.
  QStringList paths() const { return m_files.paths(); }
  /// In a protocol by worth (`isByWorth`), the index of the next sighting, which has the highest worth.
  /// Passed to `progressOf` as `chosen`; absent until it is computed.
  std::optional<std::size_t> chosenSighting() const { return m_chosenSighting; }
  void setChosenSighting(std::optional<std::size_t> chosen);
  /// Files from which parts of the session were read: readings, instrument, protocol.
  QStringList readPaths() const { return m_readPaths; }
  void noteRead(const QStringList& paths) { m_readPaths += paths; }
  QString displayName() const;  ///< the file's name, or "Untitled"
  /// Which session is current: each new, opened or imported session has a number of its own.
  int sessionNumber() const { return m_files.session(m_undoStack.index()); }
  bool isModified() const { return m_files.isModified(m_undoStack.index()); }
  /// The path of another session with unsaved changes, to which redo (ahead) or undo (behind) leads.
  std::optional<QString> unsavedAhead() const {
    return m_files.unsavedAhead(m_undoStack.index(), m_undoStack.count());
  }
  std::optional<QString> unsavedBehind() const {
    return m_files.unsavedBehind(m_undoStack.index(), m_undoStack.count());
  }

  /// Pushes an edit onto the undo stack. Takes ownership of the command.
  void push(QUndoCommand* command);
  /// Pushes a command that replaces the present session by an unsaved one.
  void pushAnother(QUndoCommand* command);
  /// Writes to the session; emits `aboutToChange` before and `changed` after writing.
  void edit(EditKey key, const SessionChange& change, const std::function<void(Session&)>& write);
  JournalKeeper& journal(EditKey /*key*/) { return m_journal; }
  /// Edits pushed until `endTogether` form one undo step.
  void beginTogether(const QString& undoText);
  void endTogether();

  void startNew();
  /// Starts with an unsaved session.
  void startWith(Session session);
  /// Starts with an unsaved session that was in a file before: its entries count as recorded, so changes
  /// enter the journal.
  void startWithRecorded(Session session);
  /// Loads a session, also one with invalid entries. If the file cannot be read as a session, returns the
  /// problem and leaves the document unchanged.
  [[nodiscard]] std::optional<Problem> load(const QString& path);
  void startFrom(FiledSession file, const QString& path);
  /// Saves completely, or returns the problem and leaves the old file.
  [[nodiscard]] std::optional<Problem> save(const QString& path);
  /// SHA-256 of the bytes last read from or written to `path()`; empty if the file was never read or written.
  QByteArray knownSha256() const { return m_knownSha256.value(path()); }
  /// Records that the current session equals the file at `path`, whose bytes have this SHA-256.
  void markSaved(const QString& path, const QByteArray& sha256);
  /// Records that the file at `path()` is gone: the session is modified until it is saved again.
  void markFileGone();

 signals:
  void aboutToChange(const alidade::ui::SessionChange& change);
  void changed(const alidade::ui::SessionChange& change);
  void identityChanged();  ///< path or modified state changed
  void chosenSightingChanged();
  /// An edit, not its undo or redo, added the journal entries from the index `first` on.
  void recorded(std::size_t first);

 private:
  void emitRecorded(std::size_t first);
  void replaceAll(Session session, const QString& path, bool isNew);

  Session m_session;
  QUndoStack m_undoStack;
  HalfTyped m_halfTyped;
  JournalKeeper m_journal{m_session};
  SessionFiles m_files;
  QStringList m_readPaths;
  std::optional<std::size_t> m_journalBefore;  ///< length of the journal at `beginTogether`
  std::optional<std::size_t> m_chosenSighting;
  QHash<QString, QByteArray> m_knownSha256;  ///< by path
};

}  // namespace alidade::ui
