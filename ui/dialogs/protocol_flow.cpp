#include "ui/dialogs/protocol_flow.h"

#include <QFileInfo>

#include "core/guidance/advised_protocol.h"
#include "core/session/entry.h"
#include "core/session/protocol_progress.h"
#include "core/simulation/protocol.h"
#include "ui/commands/change_session.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/written_file.h"
#include "ui/document/encoded_path.h"
#include "ui/document/session_document.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

ProtocolFlow::ProtocolFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent)
    : QObject(parent), m_document(document), m_dialogs(dialogs) {}

bool ProtocolFlow::load() {
  emit commitWanted();
  const QString path = m_dialogs.askProtocolPath(folderOf(m_document));
  if (path.isEmpty()) return false;
  const QString name = visibleLine(QFileInfo(path).fileName());
  const Result<SightingProtocol> protocol = loadProtocol(encodedPath(path));
  if (!protocol) {
    m_dialogs.showProblem(
        tr("Follow a protocol"),
        tr("The protocol “%1” cannot be followed.\n\n%2").arg(name, visibleLine(protocol.problem().text())));
    return false;
  }
  followProtocol(m_document, *protocol);
  m_document.noteRead({path});
  emit remark(tr("The session follows “%1”").arg(name));
  return true;
}

bool ProtocolFlow::save() {
  emit commitWanted();
  const QString title = tr("Save as a measurement protocol");
  const auto protocol = protocolOf(m_document.session());
  if (!protocol || !*protocol) {
    m_dialogs.showProblem(
        title, protocol ? tr("The session follows no protocol.") : visibleLine(protocol.problem().text()));
    return false;
  }
  QString fileName = QString::fromStdString((*protocol)->name).simplified();
  if (fileName.isEmpty()) fileName = tr("protocol");
  const auto path = writeForSession(m_document, m_dialogs, title, fileName,
                                    QStringLiteral("alidade-protocol"), writeProtocol(**protocol));
  if (!path) return false;
  emit remark(tr("Saved “%1”").arg(visibleLine(QFileInfo(*path).fileName())));
  return true;
}

/// Edits the session's protocol, else a protocol made from its rows, else the template "there-and-back".
bool ProtocolFlow::edit() {
  emit commitWanted();
  const Session& session = m_document.session();
  const auto own = protocolOf(session);
  SightingProtocol protocol = own && *own ? **own : protocolFromRows(session);
  if (protocol.positions.empty()) {
    protocol = *templateNamed("there-and-back");
    protocol.name.clear();
    protocol.description.clear();
  }
  const auto edited = m_dialogs.askProtocol(protocol, circleUnitOf(session));
  if (!edited) return false;
  followProtocol(m_document, *edited);
  return true;
}

}  // namespace alidade::ui
