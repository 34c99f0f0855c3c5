#include "ui/dialogs/file_flow.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QScopeGuard>
#include <algorithm>

#include "core/base/clock.h"
#include "core/base/file_bytes.h"
#include "core/base/file_target.h"
#include "core/session/next_session.h"
#include "ui/commands/session_commands.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/in_background.h"
#include "ui/document/encoded_path.h"
#include "ui/document/session_document.h"
#include "ui/import/import_page.h"
#include "ui/report/attached_session.h"
#include "ui/settings/recent_files.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

/// Adds the journal entries on the origin of imported rows to a new session.
void enterOrigins(Session& session, std::vector<JournalEntry> origins) {
  for (JournalEntry& entry : origins) {
    entry.at = timeInUtc();
    entry.by = session.operatorName;
    enterInJournal(session.journal, std::move(entry));
  }
}

/// True if no other session has unsaved changes (`path` is absent), or the user agrees to discard them.
bool mayDrop(Dialogs& dialogs, const std::optional<QString>& path, Dialogs::Way way) {
  return !path || dialogs.askDiscardOther(QFileInfo(*path).fileName(), way);
}

}  // namespace

FileFlow::FileFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent)
    : QObject(parent), m_document(document), m_dialogs(dialogs), m_reports(document, dialogs) {
  connect(&m_reports, &ReportFlow::commitWanted, this, &FileFlow::commitWanted);
  connect(&m_reports, &ReportFlow::remark, this, &FileFlow::remark);
  connect(&document, &SessionDocument::identityChanged, this, [this] { m_lock.hold(m_document.path()); });
}

/// Holds the session until the returned guard ends.
auto FileFlow::held() {
  if (m_holds++ == 0) emit holding(true);
  return qScopeGuard([this] {
    if (--m_holds == 0) emit holding(false);
  });
}

void FileFlow::setLockFolder(const QString& folder) {
  m_lock.setFolder(folder);
}

bool FileFlow::startNew() {
  if (!mayLeave()) return false;
  m_document.startNew();
  return true;
}

bool FileFlow::startNext() {
  emit commitWanted();
  Session next = nextSession(m_document.session());
  next.measuredOn = localDay();
  return startWith(next);
}

bool FileFlow::startWith(const Session& session) {
  if (!mayLeave()) return false;
  m_document.startWith(session);
  return true;
}

bool FileFlow::open() {
  if (!mayLeave()) return false;
  const QString path = m_dialogs.askOpenPath(QFileInfo(m_document.path()).absolutePath());
  return !path.isEmpty() && load(path);
}

bool FileFlow::open(const QString& path) {
  if (isReadingsFile(path)) return importReadings(QStringList(path));
  return mayLeave() && load(path);
}

bool FileFlow::importReadings() {
  const QStringList paths = m_dialogs.askImportPaths(QFileInfo(m_document.path()).absolutePath());
  return !paths.isEmpty() && importReadings(paths);
}

bool FileFlow::importReadings(const QStringList& paths) {
  for (const QString& path : paths)
    if (isRefusedAsNonFile(tr("Import readings"), path)) return false;
  const QString name =
      paths.size() == 1 ? visibleLine(QFileInfo(paths.first()).fileName()) : tr("%1 files").arg(paths.size());
  const auto sources = inBackground<Result<std::vector<ImportSource>>>(
      *m_dialogs.busy(tr("Reading %1…").arg(paths.size() == 1 ? u'“' + name + u'”' : name)),
      [paths](const std::stop_token&) { return readSources(paths); });
  if (!sources || !importFrom(*sources, name)) return false;
  m_document.noteRead(paths);
  return true;
}

bool FileFlow::importClipboard() {
  const QString name = tr("clipboard");
  const std::string text = QApplication::clipboard()->text().toStdString();
  const auto sources = inBackground<Result<std::vector<ImportSource>>>(
      *m_dialogs.busy(tr("Reading the clipboard…")),
      [name, text](const std::stop_token&) { return textSource(name, text); });
  return sources && importFrom(*sources, name);
}

bool FileFlow::importFrom(const Result<std::vector<ImportSource>>& sources, const QString& name) {
  if (!sources) {
    m_dialogs.showProblem(tr("Import readings"), qText(sources.problem().text()));
    return false;
  }
  emit commitWanted();
  const auto hold = held();
  auto decision = m_dialogs.askImport(
      {.sources = *sources, .session = std::make_shared<const Session>(m_document.session())});
  if (!decision) return false;
  if (!(decision->isAdded || mayLeaveChanges()) || !mayDropRedo()) return false;
  const QString text = tr("Import %1").arg(name);
  if (decision->isAdded) {
    m_document.push(
        new ImportReadings(m_document, std::move(decision->session), std::move(decision->origins), text));
  } else {
    enterOrigins(decision->session, std::move(decision->origins));
    m_document.pushAnother(new ReplaceSession(m_document, std::move(decision->session), text));
  }
  emit remark(decision->rows == 1 ? tr("1 row of readings imported from %1").arg(name)
                                  : tr("%1 rows of readings imported from %2").arg(decision->rows).arg(name));
  return true;
}

/// Reports a path that is not a regular file, and returns true. Reading a pipe or a device may never end and
/// block the window. For a missing file, opening or writing reports the problem.
bool FileFlow::isRefusedAsNonFile(const QString& title, const QString& path) {
  const QFileInfo file(path);
  if (!file.exists() || file.isFile()) return false;
  const QString kind = file.isDir() ? tr("a folder") : tr("a pipe or a device");
  m_dialogs.showProblem(title, tr("“%1” is %2: choose a file.").arg(visibleLine(path), kind));
  return true;
}

bool FileFlow::load(const QString& path) {
  if (isRefusedAsNonFile(tr("Open session"), path)) return false;
  if (isPdfFile(path)) return loadAttached(path);
  if (!mayShare(path)) return false;
  const QString name = visibleLine(QFileInfo(path).fileName());
  auto file = inBackground<Result<FiledSession>>(*m_dialogs.busy(tr("Opening “%1”…").arg(name)),
                                                 [path](const std::stop_token&) { return readFiled(path); });
  if (!file) return false;
  if (!*file) {
    m_dialogs.showProblem(tr("Open session"),
                          tr("“%1” cannot be opened.\n\n%2").arg(name, visibleLine(file->problem().text())));
    return false;
  }
  m_document.startFrom(**std::move(file), path);
  RecentFiles::add(path);
  emit recentFilesChanged();
  return true;
}

/// Opens the session without a file: the report stays unchanged, and saving asks for a name.
bool FileFlow::loadAttached(const QString& path) {
  const QString name = visibleLine(QFileInfo(path).fileName());
  const auto session =
      inBackground<Result<Session>>(*m_dialogs.busy(tr("Opening the session in “%1”…").arg(name)),
                                    [path](const std::stop_token&) { return readAttachedSession(path); });
  if (!session) return false;
  if (!*session) {
    m_dialogs.showProblem(
        tr("Open report"),
        tr("“%1” cannot be opened.\n\n%2").arg(name, visibleLine(session->problem().text())));
    return false;
  }
  m_document.startWithRecorded(**session);
  emit remark(tr("Opened the session attached to %1; it is not saved in a file of its own yet").arg(name));
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

bool FileFlow::revert() {
  emit commitWanted();
  const QString path = m_document.path();
  if (path.isEmpty() || !m_document.isModified() || isRefusedAsNonFile(tr("Revert"), path)) return false;
  const auto hold = held();
  const QString name = visibleLine(m_document.displayName());
  auto file = inBackground<Result<FiledSession>>(*m_dialogs.busy(tr("Opening “%1”…").arg(name)),
                                                 [path](const std::stop_token&) { return readFiled(path); });
  if (!file) return false;
  if (!*file) {
    m_dialogs.showProblem(tr("Revert"),
                          tr("“%1” cannot be opened.\n\n%2").arg(name, visibleLine(file->problem().text())));
    return false;
  }
  m_document.push(new ReplaceSession(m_document, (*file)->session, tr("Revert")));
  m_document.markSaved(path, (*file)->sha256);
  emit remark(tr("Reverted to %1; Undo restores the changes.").arg(QDir::toNativeSeparators(path)));
  return true;
}

bool FileFlow::saveTo(const QString& path) {
  if (isRefusedAsNonFile(tr("Save session"), path)) return false;
  if (!isSameFile(encodedPath(path), encodedPath(m_document.path()))) return mayShare(path) && write(path);
  const auto answer = askAboutChange();
  if (answer == ChangedFileAnswer::SaveAs) return saveAs();
  return (!answer || answer == ChangedFileAnswer::Overwrite) && write(path);
}

/// Excludes the session's own files, since saving replaces them.
QStringList FileFlow::otherInputs() const {
  QStringList inputs = m_dialogs.readFiles();
  for (const QString& own : m_document.paths()) inputs.removeAll(own);
  return inputs;
}

bool FileFlow::write(const QString& path) {
  const auto hold = held();
  const auto written = inBackground<Result<QByteArray>>(
      *m_dialogs.busy(tr("Saving “%1”…").arg(visibleLine(QFileInfo(path).fileName())), Busy::Way::ToItsEnd),
      [session = m_document.session(), path, inputs = otherInputs()](const std::stop_token&) {
        return writeFiled(session, path, inputs);
      });
  if (!*written) {
    m_dialogs.showProblem(tr("Save session"), visibleLine(written->problem().text()));
    return false;
  }
  m_document.markSaved(path, **written);
  RecentFiles::add(path);
  emit recentFilesChanged();
  emit remark(tr("Saved %1").arg(QDir::toNativeSeparators(path)));
  return true;
}

bool FileFlow::mayShare(const QString& path) {
  const QString holder = m_lock.holder(path);
  return holder.isEmpty() || m_dialogs.askOpenElsewhere(visibleLine(QFileInfo(path).fileName()), holder);
}

void FileFlow::resolveChange() {
  emit commitWanted();
  const auto answer = askAboutChange();
  if (answer == ChangedFileAnswer::SaveAs) saveAs();
  if (answer == ChangedFileAnswer::Overwrite) write(m_document.path());
}

/// Asks what to do if another program changed the file; absent if it did not. Performs a chosen reload.
std::optional<ChangedFileAnswer> FileFlow::askAboutChange() {
  const auto hold = held();
  auto looked = inBackground<std::optional<FileContent>>(
      *m_dialogs.busy(tr("Checking “%1” for changes…").arg(visibleLine(m_document.displayName())),
                      Busy::Way::ToItsEnd),
      [known = m_document.knownSha256(), path = m_document.path()](const std::stop_token&) {
        return contentOtherThan(known, path);
      });
  if (!*looked) return {};
  FileContent theirs = **std::move(looked);
  ChangedFile file{.name = visibleLine(m_document.displayName())};
  if (theirs.session)
    file.difference = differenceOf(m_document.session(), *theirs.session);
  else
    file.problem = visibleLine(theirs.session.problem().text());
  if (file.difference && file.difference->count == 0) {
    m_document.markSaved(m_document.path(), theirs.sha256);
    return {};
  }
  const ChangedFileAnswer answer = m_dialogs.askChangedFile(file);
  if (answer == ChangedFileAnswer::Reload && theirs.session) {
    m_document.push(new ReplaceSession(m_document, *std::move(theirs.session), tr("Reload")));
    m_document.markSaved(m_document.path(), theirs.sha256);
  }
  return answer;
}

bool FileFlow::seal() {
  emit commitWanted();
  const Session& session = m_document.session();
  const std::string& who =
      session.report.authorisedBy.empty() ? session.operatorName : session.report.authorisedBy;
  const QString by = m_dialogs.askSeal(qText(who));
  if (by.isEmpty()) return false;
  m_document.push(new SealSession(m_document, by.toStdString()));
  return save();
}

bool FileFlow::exportReport() {
  return m_reports.exportPdf(suggestedPath(QStringLiteral("pdf")));
}

bool FileFlow::exportCertificate() {
  return m_reports.exportCertificate(suggestedPath(QStringLiteral("xml")));
}

bool FileFlow::printReport() {
  return m_reports.print();
}

bool FileFlow::previewReport() {
  return m_reports.preview(suggestedPath(QStringLiteral("pdf")));
}

bool FileFlow::mayLeave() {
  emit commitWanted();
  return mayLeaveChanges() && mayDropRedo() && mayDropUndo();
}

bool FileFlow::mayLeaveChanges() {
  if (const QString path = m_document.path(); !path.isEmpty() && !QFileInfo::exists(path))
    m_document.markFileGone();
  const Dialogs::Unsaved unsaved{m_document.displayName(), m_document.isModified(),
                                 m_waiting ? m_waiting() : 0};
  if (!unsaved.isModified && unsaved.waiting == 0) return true;
  switch (m_dialogs.askLeave(unsaved)) {
    case Dialogs::SaveAnswer::Save:
      return save() && mayLeaveChanges();  // a reading may wait still, or may have come in since
    case Dialogs::SaveAnswer::Discard:
      return true;
    case Dialogs::SaveAnswer::Cancel:
      break;
  }
  return false;
}

/// Asks about unsaved changes of a session to which redo leads, such as the session of an undone import.
bool FileFlow::mayDropRedo() {
  return mayDrop(m_dialogs, m_document.unsavedAhead(), Dialogs::Way::Redo);
}

/// Asks about unsaved changes of a session to which undo leads, such as the session before an import.
bool FileFlow::mayDropUndo() {
  return mayDrop(m_dialogs, m_document.unsavedBehind(), Dialogs::Way::Undo);
}

QString FileFlow::suggestedPath(const QString& suffix) const {
  if (m_document.path().isEmpty()) {
    return QDir::home().filePath(QStringLiteral("%1.%2").arg(m_document.displayName(), suffix));
  }
  const QFileInfo file(m_document.path());
  return file.absoluteDir().filePath(QStringLiteral("%1.%2").arg(file.completeBaseName(), suffix));
}

}  // namespace alidade::ui
