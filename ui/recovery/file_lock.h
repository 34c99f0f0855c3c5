#pragma once

#include <QLockFile>
#include <QString>
#include <memory>

namespace alidade::ui {

/// Tells the windows of one user, in whatever process, that a session file is open: by lock files in a folder
/// of their own, one for each file. A lock whose process is gone counts for nothing.
class FileLock {
 public:
  /// Without a folder nothing is locked, and nothing is found locked.
  void setFolder(const QString& folder) { m_folder = folder; }

  /// Who else has the file open, "process 4711"; empty: nobody.
  QString holder(const QString& path) const;
  /// This window has the file open, and no longer the one before. Where another holds it, tried again at the
  /// next call.
  void hold(const QString& path);

 private:
  std::unique_ptr<QLockFile> lockOf(const QString& path) const;

  QString m_folder, m_path;
  std::unique_ptr<QLockFile> m_lock;
};

}  // namespace alidade::ui
