#include "ui/settings/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace alidade::ui {

namespace {

const QString key = QStringLiteral("recentFiles");
constexpr qsizetype limit = 10;

}  // namespace

QStringList RecentFiles::existing() {
  QStringList files;
  for (const QString& path : all()) {
    if (QFileInfo::exists(path)) files.append(path);
  }
  return files;
}

QStringList RecentFiles::all() {
  return QSettings().value(key).toStringList();
}

void RecentFiles::add(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  QStringList files = all();
  files.removeAll(absolute);
  files.prepend(absolute);
  QSettings().setValue(key, files.mid(0, limit));
}

void RecentFiles::clear() {
  QSettings().remove(key);
}

}  // namespace alidade::ui
