#pragma once

#include <QLockFile>
#include <QString>
#include <memory>

namespace alidade::ui {

/// Shows the windows of one user, in any process, which session files are open: by lock files in a folder,
/// one for each file. Locks of terminated processes are ignored.
class FileLock {
 public:
  /// Without a folder nothing is locked, and nothing is found locked.
  void setFolder(const QString& folder) { m_folder = folder; }

  /// The other holder of the file, "process 4711"; empty: nobody.
  QString holder(const QString& path) const;
  /// Locks this file for the window, and releases the previous one. If another window holds it, the next call
  /// tries again.
  void hold(const QString& path);

 private:
  std::unique_ptr<QLockFile> lockOf(const QString& path) const;

  QString m_folder, m_path;
  std::unique_ptr<QLockFile> m_lock;
};

}  // namespace alidade::ui
