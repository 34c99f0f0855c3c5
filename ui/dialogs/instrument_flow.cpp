#include "ui/dialogs/instrument_flow.h"

#include <QFileInfo>

#include "core/base/clock.h"
#include "core/session/taken_record.h"
#include "ui/commands/change_session.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/written_file.h"
#include "ui/document/encoded_path.h"
#include "ui/document/session_document.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

InstrumentFlow::InstrumentFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent)
    : QObject(parent), m_document(document), m_dialogs(dialogs) {}

bool InstrumentFlow::take() {
  emit commitWanted();
  const QString path = m_dialogs.askRecordPath(folderOf(m_document));
  if (path.isEmpty()) return false;
  const QString name = QFileInfo(path).fileName();
  const auto refuse = [&](const Problem& problem) {
    m_dialogs.showProblem(
        tr("Take from the instrument record"),
        tr("“%1” cannot be used.\n\n%2").arg(visibleLine(name), visibleLine(problem.text())));
    return false;
  };
  const Result<InstrumentRecord> record = loadInstrumentRecord(encodedPath(path));
  if (!record) return refuse(record.problem());
  if (const auto problem = takeRecord(m_document, *record, name.toStdString())) return refuse(*problem);
  m_document.noteRead({path});
  const QString taken =
      tr("Taken from “%1”, known sizes: %2").arg(visibleLine(name)).arg(record->known.size());
  emit remark(record->due.empty() || record->due >= localDay()
                  ? taken
                  : tr("%1. Its next check was due on %2.").arg(taken, visibleLine(record->due)));
  return true;
}

bool InstrumentFlow::save() {
  emit commitWanted();
  InstrumentRecord record = recordOf(m_document.session());
  if (record.date.empty()) record.date = localDay();
  const QString title = tr("Save as instrument record");
  const std::string bytes = writeInstrumentRecord(record);
  if (const auto readable = readInstrumentRecord(bytes); !readable) {
    m_dialogs.showProblem(title, tr("The session's instrument data cannot be saved as a record.\n\n%1")
                                     .arg(visibleLine(readable.problem().text())));
    return false;
  }
  const QString name = record.serial.empty() ? tr("instrument") : QString::fromStdString(record.serial);
  const auto path =
      writeForSession(m_document, m_dialogs, title, name, QStringLiteral("alidade-instrument"), bytes);
  if (!path) return false;
  emit remark(tr("Saved “%1”").arg(visibleLine(QFileInfo(*path).fileName())));
  return true;
}

}  // namespace alidade::ui
