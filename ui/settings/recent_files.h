#pragma once

#include <QStringList>

namespace alidade::ui {

/// The last opened files, newest first, at most ten, remembered between starts.
class RecentFiles {
 public:
  /// Leaves out missing files (for example on an unplugged drive), but remembers them.
  static QStringList existing();
  static QStringList all();
  static void add(const QString& path);
  static void clear();
};

}  // namespace alidade::ui
