#include "ui/document/session_template.h"

#include <QSettings>

#include "core/session/session_file.h"

namespace alidade::ui {

namespace {

const QString templateKey = QStringLiteral("newSession");

}  // namespace

Session templateSession() {
  const QByteArray kept = QSettings().value(templateKey).toByteArray();
  if (kept.isEmpty()) return blankSession();
  Result<Session> session = readSession(kept.toStdString());
  return session ? *std::move(session) : blankSession();
}

void keepTemplate(const Session& session) {
  if (session == blankSession())
    QSettings().remove(templateKey);
  else
    QSettings().setValue(templateKey, QByteArray::fromStdString(writeSession(session)));
}

}  // namespace alidade::ui
