#include "ui/dialogs/report_flow.h"

#include <QCryptographicHash>
#include <QFileInfo>

#include "core/base/file_bytes.h"
#include "ui/document/encoded_path.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

ReportSource reportSource(const SessionDocument& document) {
  const QString name = document.path().isEmpty() ? QString() : document.displayName();
  ReportSource source{.fileName = name, .sha256 = {}, .saved = false, .paths = document.paths(), .bytes = {}};
  if (document.isModified() || !QFileInfo(document.path()).isFile()) return source;
  const Result<std::string> bytes = readFile(encodedPath(document.path()));
  if (!bytes) return source;
  source.bytes = QByteArray::fromStdString(*bytes);
  source.sha256 = QCryptographicHash::hash(source.bytes, QCryptographicHash::Sha256);
  source.saved = source.sha256 == document.knownSha256();  // false: another program wrote the file
  return source;
}

}  // namespace alidade::ui
