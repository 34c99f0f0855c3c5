#include "ui/dialogs/written_file.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include "core/base/atomic_file.h"
#include "ui/dialogs/dialogs.h"
#include "ui/document/encoded_path.h"
#include "ui/document/session_document.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

std::optional<QString> writeToChosenPath(Dialogs& dialogs, const QString& title, const QString& suggested,
                                         const QString& suffix, const std::string& bytes,
                                         const QStringList& inputs) {
  const QString path = dialogs.askExportPath(title, suggested, suffix);
  if (path.isEmpty()) return std::nullopt;
  if (const auto problem = writeFile(encodedPath(path), bytes, encodedPaths(dialogs.readFiles() + inputs))) {
    dialogs.showProblem(title, visibleLine(problem->text()));
    return std::nullopt;
  }
  return path;
}

QString folderOf(const SessionDocument& document) {
  return document.path().isEmpty() ? QDir::homePath() : QFileInfo(document.path()).absolutePath();
}

std::optional<QString> writeForSession(const SessionDocument& document, Dialogs& dialogs,
                                       const QString& title, const QString& name, const QString& suffix,
                                       const std::string& bytes) {
  QString fileName = name.simplified();
  static const QRegularExpression refused(QStringLiteral("[/\\\\:*?\"<>|]"));  // in some file systems
  fileName.replace(refused, QStringLiteral("-"));
  return writeToChosenPath(dialogs, title, QDir(folderOf(document)).filePath(fileName + u'.' + suffix),
                           suffix, bytes);
}

}  // namespace alidade::ui
