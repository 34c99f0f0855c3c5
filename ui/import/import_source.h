#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/exchange/recognise.h"

namespace alidade::ui {

/// A file of readings, or the clipboard text, with its recognised format.
struct ImportSource {
  QString name;   ///< file name without folder
  QString title;  ///< title for a new session; empty if none
  std::shared_ptr<const std::string> bytes;
  std::string sha256;  ///< of the bytes
  Recognised recognised;
};

/// May run on any thread. The problem names the file that cannot be imported, and the reason.
Result<std::vector<ImportSource>> readSources(const QStringList& paths);
Result<std::vector<ImportSource>> textSource(const QString& name, const std::string& text);

/// True for the name of a file of readings, or of a format that is recognised but refused.
bool isReadingsFile(const QString& path);

/// The name patterns of files of readings for a file dialog: `*.gsi *.GSI …`.
QString readingsPatterns();

}  // namespace alidade::ui
