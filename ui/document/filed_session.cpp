#include "ui/document/filed_session.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <string>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/file_bytes.h"
#include "core/session/session_file.h"
#include "ui/document/encoded_path.h"

namespace alidade::ui {

namespace {

QByteArray sha256(const std::string& bytes) {
  return QCryptographicHash::hash({bytes.data(), static_cast<qsizetype>(bytes.size())},
                                  QCryptographicHash::Sha256);
}

}  // namespace

Result<FiledSession> readFiled(const QString& path) {
  const Result<std::string> bytes = readFile(encodedPath(path));
  if (!bytes) return bytes.problem();
  Result<Session> session = readSession(*bytes);
  if (!session) return session.problem();
  return FiledSession{*std::move(session), sha256(*bytes)};
}

Result<QByteArray> writeFiled(const Session& session, const QString& path, const QStringList& inputs) {
  const std::string text = writeSession(session);
  if (auto problem = writeFile(encodedPath(path), text, encodedPaths(inputs))) return *std::move(problem);
  return sha256(text);
}

std::optional<FileContent> contentOtherThan(const QByteArray& knownSha256, const QString& path) {
  if (!QFileInfo(path).isFile()) return {};
  const Result<std::string> bytes = readFile(encodedPath(path));
  if (!bytes) return {};
  QByteArray own = sha256(*bytes);
  if (own == knownSha256) return {};
  return FileContent{std::move(own), readSession(*bytes)};
}

QByteArray sha256OfFile(const QString& path) {
  QFile file(path);
  QCryptographicHash hash(QCryptographicHash::Sha256);
  if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly) || !hash.addData(&file)) return {};
  return hash.result();
}

}  // namespace alidade::ui
