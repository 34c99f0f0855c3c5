#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

namespace alidade::ui {

/// The files of the sessions on one undo stack. An import begins another session; undo returns to the
/// previous one. Each session can have a file, and the stack index at which the session equals that file.
/// Indices are those of `QUndoStack`: the number of executed commands.
class SessionFiles {
 public:
  /// Starts with an empty stack and one session, which equals its file if `path` is not empty.
  void restart(const QString& path);
  /// Called before the commands from `index` on are dropped from the stack.
  void dropFrom(int index);
  /// Called before the command at `index` replaces the present session by another, after the user agreed to
  /// leave unsaved changes of the present session unsaved.
  void beginAnother(int index);
  /// Records that the session at `index` was saved in `path`. If another session had this file, that session
  /// then has no file, as the user agreed.
  void setSaved(int index, const QString& path);
  /// Records that the file of the session at `index` is gone, so that the session is saved nowhere.
  void setUnsaved(int index) { m_files[at(index)].savedAt = -1; }

  QStringList paths() const;                                         ///< paths of all sessions with a file
  QString path(int index) const { return m_files[at(index)].path; }  ///< empty: never saved
  bool isModified(int index) const { return m_files[at(index)].savedAt != index; }
  /// A number that no other session has had in these files: it tells which session is current at `index`.
  int session(int index) const { return m_files[at(index)].session; }
  /// The path of a session with unsaved changes to which redo leads from `index`; absent if redo leads to no
  /// unsaved changes. `count`: the number of commands on the stack.
  std::optional<QString> unsavedAhead(int index, int count) const;
  /// Like `unsavedAhead`, for sessions to which undo leads, except those that the user left unsaved.
  std::optional<QString> unsavedBehind(int index, int count) const;

 private:
  struct File {
    QString path = {};
    int session = 0;
    int begins = 0;          ///< index from which on the session is current
    int savedAt = -1;        ///< index at which the session equals its file; −1: none
    bool isGivenUp = false;  ///< the user agreed to leave the session unsaved
  };

  std::size_t at(int index) const;
  bool isUnsaved(std::size_t file, int count) const;

  std::vector<File> m_files = {{.savedAt = 0}};  ///< in the order of the stack
  int m_lastSession = 0;
};

}  // namespace alidade::ui
