#pragma once

#include <QStringList>

namespace alidade::ui {

/// The files opened last, newest first, at most ten, remembered from one start to the next.
class RecentFiles {
 public:
  /// Files that cannot be found now (a drive that is not plugged in) are left out, but not forgotten.
  static QStringList existing();
  static QStringList all();
  static void add(const QString& path);
  static void clear();
};

}  // namespace alidade::ui
