#include "ui/dialogs/report_source.h"

#include <QCryptographicHash>
#include <QFile>

#include "core/session/session_file.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

namespace {

QByteArray sha256(const QByteArray& bytes) {
  return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
}

}  // namespace

ReportSource reportSource(const SessionDocument& document) {
  QFile file(document.path());
  const bool saved = !document.path().isEmpty() && !document.isModified() && file.open(QIODevice::ReadOnly);
  const QByteArray bytes =
      saved ? file.readAll() : QByteArray::fromStdString(writeSession(document.session()));
  const QString name = document.path().isEmpty() ? QString() : document.displayName();
  return {name, sha256(bytes), saved, document.paths()};
}

}  // namespace alidade::ui
