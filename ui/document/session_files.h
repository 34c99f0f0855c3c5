#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

namespace alidade::ui {

/// The files of the sessions on one undo stack: an import begins another session, and undo leads back to the
/// one before. Each has its file, and the index of the stack at which it is as in its file. An index is that
/// of `QUndoStack`: how many commands are done.
class SessionFiles {
 public:
  /// One session alone, as in its file where it has one: the stack is empty.
  void restart(const QString& path);
  /// The commands from `index` on are about to be dropped from the stack.
  void dropFrom(int index);
  /// The next command, at `index`, puts another session in place of the present one. That one may be left as
  /// it is: the user was asked.
  void beginAnother(int index);
  /// The session at `index` is now in `path`, and the one that was there before is in no file: the user
  /// wanted that.
  void setSaved(int index, const QString& path);

  QStringList paths() const;                                         ///< of all sessions that have one
  QString path(int index) const { return m_files[at(index)].path; }  ///< empty: never saved
  bool isModified(int index) const { return m_files[at(index)].savedAt != index; }
  /// A session that redo leads to from `index` and that is not in its file as it was last, where `count`
  /// commands are on the stack: its path. Absent: there is none.
  std::optional<QString> unsavedAhead(int index, int count) const;
  /// Likewise one that undo leads back to. Those that the user has given up do not count.
  std::optional<QString> unsavedBehind(int index, int count) const;

 private:
  struct File {
    QString path = {};
    int begins = 0;          ///< index from which on the session is at work
    int savedAt = -1;        ///< index at which it is as in its file; −1: nowhere
    bool isGivenUp = false;  ///< the user was asked, and left it as it was last
  };

  std::size_t at(int index) const;
  bool isUnsaved(std::size_t file, int count) const;

  std::vector<File> m_files = {{.savedAt = 0}};  ///< in the order of the stack
};

}  // namespace alidade::ui
