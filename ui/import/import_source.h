#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/exchange/recognise.h"

namespace alidade::ui {

/// A file of readings, or the text of the clipboard, with what it looks to be.
struct ImportSource {
  QString name;   ///< of the file, without its folder
  QString title;  ///< for a session made of it; empty where it has none
  std::shared_ptr<const std::string> bytes;
  std::string sha256;  ///< of them
  Recognised recognised;
};

/// On any thread. The problem says which file cannot be imported, and why.
Result<std::vector<ImportSource>> readSources(const QStringList& paths);
Result<std::vector<ImportSource>> textSource(const QString& name, const std::string& text);

/// Is this the name of a file of readings, or of one whose format is named and refused?
bool isReadingsFile(const QString& path);

/// The patterns of such names, as a file dialog takes them: `*.gsi *.GSI …`.
QString readingsPatterns();

}  // namespace alidade::ui
