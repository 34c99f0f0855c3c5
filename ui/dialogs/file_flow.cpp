#include "ui/dialogs/file_flow.h"

#include <QDir>
#include <QFileInfo>

#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/report_source.h"
#include "ui/document/session_document.h"
#include "ui/jobs/evaluation.h"
#include "ui/settings/recent_files.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

FileFlow::FileFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent)
    : QObject(parent), m_document(document), m_dialogs(dialogs) {}

bool FileFlow::startNew() {
  if (!mayLeave()) return false;
  m_document.startNew();
  return true;
}

bool FileFlow::open() {
  if (!mayLeave()) return false;
  const QString path = m_dialogs.askOpenPath(QFileInfo(m_document.path()).absolutePath());
  return !path.isEmpty() && load(path);
}

bool FileFlow::open(const QString& path) {
  return mayLeave() && load(path);
}

bool FileFlow::load(const QString& path) {
  if (const auto problem = m_document.load(path)) {
    m_dialogs.showProblem(
        tr("Open session"),
        tr("“%1” cannot be opened.\n\n%2").arg(QFileInfo(path).fileName(), qText(problem->text())));
    return false;
  }
  RecentFiles::add(path);
  emit recentFilesChanged();
  return true;
}

bool FileFlow::save() {
  emit commitWanted();
  return m_document.path().isEmpty() ? saveAs() : saveTo(m_document.path());
}

bool FileFlow::saveAs() {
  emit commitWanted();
  const QString path = m_dialogs.askSavePath(suggestedPath(QStringLiteral("alidade")));
  return !path.isEmpty() && saveTo(path);
}

bool FileFlow::saveTo(const QString& path) {
  if (const auto problem = m_document.save(path)) {
    m_dialogs.showProblem(tr("Save session"), qText(problem->text()));
    return false;
  }
  RecentFiles::add(path);
  emit recentFilesChanged();
  emit remark(tr("Saved %1").arg(QDir::toNativeSeparators(path)));
  return true;
}

bool FileFlow::exportReport() {
  emit commitWanted();
  const Evaluation evaluation = evaluate(m_document.session());
  const auto unusable = static_cast<int>(evaluation.examined.problems.size());
  if (unusable > 0 && !m_dialogs.askReportWithoutVerdict(unusable)) return false;
  const QString path = m_dialogs.askReportPath(suggestedPath(QStringLiteral("pdf")));
  if (path.isEmpty()) return false;
  const Result<QString> written = writeAcceptanceReport(evaluation, reportSource(m_document), path);
  if (!written) {
    m_dialogs.showProblem(tr("Export acceptance report"), qText(written.problem().text()));
    return false;
  }
  emit remark(tr("Report written to %1").arg(QDir::toNativeSeparators(*written)));
  return true;
}

bool FileFlow::mayLeave() {
  emit commitWanted();
  if (!m_document.isModified()) return true;
  switch (m_dialogs.askSaveChanges(m_document.displayName())) {
    case Dialogs::SaveAnswer::Save:
      return save();
    case Dialogs::SaveAnswer::Discard:
      return true;
    case Dialogs::SaveAnswer::Cancel:
      break;
  }
  return false;
}

QString FileFlow::suggestedPath(const QString& suffix) const {
  if (m_document.path().isEmpty()) {
    return QDir::home().filePath(QStringLiteral("%1.%2").arg(m_document.displayName(), suffix));
  }
  const QFileInfo file(m_document.path());
  return file.absoluteDir().filePath(QStringLiteral("%1.%2").arg(file.completeBaseName(), suffix));
}

}  // namespace alidade::ui
