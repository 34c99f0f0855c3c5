#pragma once

#include <QStringList>

namespace alidade::ui {

/// The last opened files, newest first, at most ten, remembered between starts.
class RecentFiles {
 public:
  /// The remembered files that exist now; others may be on an unplugged drive.
  static QStringList existing();
  static QStringList all();
  static void add(const QString& path);
  static void clear();
};

}  // namespace alidade::ui
