#include "ui/document/session_template.h"

#include <QSettings>

#include "core/session/session_file.h"
#include "core/session/sighting_protocol.h"
#include "core/simulation/protocol.h"

namespace alidade::ui {

namespace {

const QString templateKey = QStringLiteral("newSession");

/// The content of a new session if no template is stored: a blank session with the usual protocol.
Session usualTemplate() {
  Session session = blankSession();
  session.protocol = protocolText(usualProtocol());
  return session;
}

}  // namespace

Session templateSession() {
  const QByteArray kept = QSettings().value(templateKey).toByteArray();
  if (kept.isEmpty()) return usualTemplate();
  Result<Session> session = readSession(kept.toStdString());
  return session ? *std::move(session) : usualTemplate();
}

void keepTemplate(const Session& session) {
  if (session == usualTemplate())
    QSettings().remove(templateKey);
  else
    QSettings().setValue(templateKey, QByteArray::fromStdString(writeSession(session)));
}

}  // namespace alidade::ui
