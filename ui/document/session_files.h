#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

namespace alidade::ui {

/// The files of the sessions on one undo stack: an import begins another session, and undo returns to the
/// previous one. Each has its file, and the stack index at which it equals its file. Indices are those of
/// `QUndoStack`: the number of executed commands.
class SessionFiles {
 public:
  /// A single session, equal to its file if it has one: the stack is empty.
  void restart(const QString& path);
  /// The commands from `index` on are about to be dropped from the stack.
  void dropFrom(int index);
  /// The next command, at `index`, replaces the present session by another. The user agreed to leave the
  /// present one as it is.
  void beginAnother(int index);
  /// The session at `index` is saved in `path`; a previous session there no longer has a file, as the user
  /// agreed.
  void setSaved(int index, const QString& path);

  QStringList paths() const;                                         ///< of all sessions with a file
  QString path(int index) const { return m_files[at(index)].path; }  ///< empty: never saved
  bool isModified(int index) const { return m_files[at(index)].savedAt != index; }
  /// The path of a session that redo leads to from `index` and that differs from its file, with `count`
  /// commands on the stack. Absent: there is none.
  std::optional<QString> unsavedAhead(int index, int count) const;
  /// As `unsavedAhead`, for sessions that undo leads back to, except those that the user left unsaved.
  std::optional<QString> unsavedBehind(int index, int count) const;

 private:
  struct File {
    QString path = {};
    int begins = 0;          ///< index from which on the session is current
    int savedAt = -1;        ///< index at which it equals its file; −1: none
    bool isGivenUp = false;  ///< the user agreed to leave it unsaved
  };

  std::size_t at(int index) const;
  bool isUnsaved(std::size_t file, int count) const;

  std::vector<File> m_files = {{.savedAt = 0}};  ///< in the order of the stack
};

}  // namespace alidade::ui
