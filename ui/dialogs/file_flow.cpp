#include "ui/dialogs/file_flow.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "core/base/file_bytes.h"
#include "core/base/file_target.h"
#include "core/exchange/import.h"
#include "core/session/row_fields.h"
#include "ui/commands/replace_session.h"
#include "ui/commands/seal_session.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/import_notes.h"
#include "ui/dialogs/in_background.h"
#include "ui/document/session_document.h"
#include "ui/report/attached_session.h"
#include "ui/settings/recent_files.h"
#include "ui/text/encoded_path.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

/// Rows that somebody began count too: what was typed is not put aside.
bool hasReadings(const Session& session) {
  return std::any_of(session.positions.begin(), session.positions.end(), [](const Position& position) {
    return !std::all_of(position.readings.begin(), position.readings.end(), isBlank);
  });
}

Session withoutRows(Session session) {
  for (Position& position : session.positions) position.readings.clear();
  return session;
}

Result<Import> readImport(const QString& path, const ImportOptions& options) {
  const Result<std::string> bytes = readFile(encodedPath(path));
  if (!bytes) return bytes.problem();
  Result<Import> import = alidade::importReadings(*bytes, options);
  if (import && import->session.title.empty()) {
    Import titled = *std::move(import);
    titled.session.title = QFileInfo(path).completeBaseName().toStdString();
    return titled;
  }
  return import;
}

/// Nothing unsaved is lost, or the user wants it lost.
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

void FileFlow::setLockFolder(const QString& folder) {
  m_lock.setFolder(folder);
}

bool FileFlow::startNew() {
  if (!mayLeave()) return false;
  m_document.startNew();
  return true;
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
  if (isReadingsFile(path)) return importReadings(path);
  return mayLeave() && load(path);
}

bool FileFlow::importReadings() {
  const QString path = m_dialogs.askImportPath(QFileInfo(m_document.path()).absolutePath());
  return !path.isEmpty() && importReadings(path);
}

bool FileFlow::importReadings(const QString& path) {
  if (tellWhereNoFile(tr("Import readings"), path)) return false;
  emit commitWanted();
  const bool intoPresent = !hasReadings(m_document.session());
  ImportOptions options;
  if (intoPresent) options.base = withoutRows(m_document.session());
  const QString name = visibleLine(QFileInfo(path).fileName());
  const auto read = inBackground<Result<Import>>(
      *m_dialogs.busy(tr("Reading “%1”…").arg(name)),
      [path, options](const std::stop_token&) { return readImport(path, options); });
  if (!read) return false;
  const Result<Import>& import = *read;
  if (!import) {
    m_dialogs.showProblem(
        tr("Import readings"),
        tr("“%1” cannot be imported.\n\n%2").arg(name, visibleLine(import.problem().text())));
    return false;
  }
  if (!(intoPresent || mayLeaveChanges()) || !mayDropRedo()) return false;
  auto* replace = new ReplaceSession(m_document, import->session, tr("Import %1").arg(name));
  intoPresent ? m_document.push(replace) : m_document.pushAnother(replace);
  tellOf(*import, name);
  return true;
}

void FileFlow::tellOf(const Import& import, const QString& name) {
  const QString done = import.rows == 1
                           ? tr("1 row of readings imported from %1").arg(name)
                           : tr("%1 rows of readings imported from %2").arg(import.rows).arg(name);
  emit remark(done);
  const QString notes = importNotes(import);
  if (!notes.isEmpty()) m_dialogs.showProblem(tr("Import readings"), done + QStringLiteral(".\n\n") + notes);
}

/// A pipe has no end, and a device may have none: the window would wait for it. What is not there at all is
/// told where it is opened or written.
bool FileFlow::tellWhereNoFile(const QString& title, const QString& path) {
  const QFileInfo file(path);
  if (!file.exists() || file.isFile()) return false;
  const QString kind = file.isDir() ? tr("a folder") : tr("a pipe or a device");
  m_dialogs.showProblem(title, tr("“%1” is %2: choose a file.").arg(visibleLine(path), kind));
  return true;
}

bool FileFlow::load(const QString& path) {
  if (tellWhereNoFile(tr("Open session"), path)) return false;
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

/// Into no file: the report stays as it is, and saving asks for a name.
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
  m_document.startWithStanding(**session);
  emit remark(tr("The session attached to %1; it is in no file of its own yet").arg(name));
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
  if (tellWhereNoFile(tr("Save session"), path)) return false;
  if (!isSameFile(encodedPath(path), encodedPath(m_document.path()))) return mayShare(path) && write(path);
  const auto answer = askAboutChange();
  if (answer == ChangedFileAnswer::SaveAs) return saveAs();
  return (!answer || answer == ChangedFileAnswer::Overwrite) && write(path);
}

bool FileFlow::write(const QString& path) {
  const auto written = inBackground<Result<QByteArray>>(
      *m_dialogs.busy(tr("Saving “%1”…").arg(visibleLine(QFileInfo(path).fileName())), Busy::Way::ToItsEnd),
      [session = m_document.session(), path](const std::stop_token&) { return writeFiled(session, path); });
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

void FileFlow::settleChange() {
  emit commitWanted();
  const auto answer = askAboutChange();
  if (answer == ChangedFileAnswer::SaveAs) saveAs();
  if (answer == ChangedFileAnswer::Overwrite) write(m_document.path());
}

/// Absent: saving overwrites nothing of others'. A reload is done already.
std::optional<ChangedFileAnswer> FileFlow::askAboutChange() {
  auto looked = inBackground<std::optional<FileContent>>(
      *m_dialogs.busy(tr("Looking at “%1”…").arg(visibleLine(m_document.displayName())), Busy::Way::ToItsEnd),
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

/// The session back from an import may be as in its file, and all that was typed into the import unsaved.
bool FileFlow::mayDropRedo() {
  return mayDrop(m_dialogs, m_document.unsavedAhead(), Dialogs::Way::Redo);
}

/// An import may be saved, and the session before it not, or no longer.
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
