#include "ui/dialogs/report_source.h"

#include "ui/document/filed_session.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

ReportSource reportSource(const SessionDocument& document) {
  const QByteArray ofFile = document.isModified() ? QByteArray() : sha256OfFile(document.path());
  const QString name = document.path().isEmpty() ? QString() : document.displayName();
  return {name, ofFile, !ofFile.isEmpty(), document.paths()};
}

}  // namespace alidade::ui
