#pragma once

#include <QFile>
#include <QString>
#include <string>

namespace alidade::ui {

/// A path as the core and the system take it.
inline std::string encodedPath(const QString& path) {
  return QFile::encodeName(path).toStdString();
}

}  // namespace alidade::ui
