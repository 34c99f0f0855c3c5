#pragma once

#include <QFile>
#include <QString>
#include <QStringList>
#include <string>
#include <vector>

namespace alidade::ui {

/// A path in the encoding of the core and the system.
inline std::string encodedPath(const QString& path) {
  return QFile::encodeName(path).toStdString();
}
inline std::vector<std::string> encodedPaths(const QStringList& paths) {
  std::vector<std::string> encoded;
  for (const QString& path : paths) encoded.push_back(encodedPath(path));
  return encoded;
}

}  // namespace alidade::ui
