#pragma once

#include <QLockFile>
#include <QString>
#include <memory>

namespace alidade::ui {

/// Makes known to every window of one user, in any process, which session files are open. Each open file has
/// a lock file in one folder. Locks of terminated processes are ignored.
class FileLock {
 public:
  /// Sets the folder of the lock files; without a folder, `hold` locks nothing and `holder` finds nothing.
  void setFolder(const QString& folder) { m_folder = folder; }

  /// The process of another window that has locked the file, such as "process 4711"; empty: none.
  QString holder(const QString& path) const;
  /// Locks this file for the window, and releases the previous file. If another window has locked the file,
  /// the next call tries again.
  void hold(const QString& path);

 private:
  std::unique_ptr<QLockFile> lockOf(const QString& path) const;

  QString m_folder, m_path;
  std::unique_ptr<QLockFile> m_lock;
};

}  // namespace alidade::ui
