#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "ui/dialogs/changed_file.h"
#include "ui/dialogs/report_flow.h"
#include "ui/import/import_source.h"
#include "ui/recovery/file_lock.h"

namespace alidade {
struct Session;
}  // namespace alidade

namespace alidade::ui {

class Dialogs;
class SessionDocument;

/// New, open, import, save, export and leaving, with the questions that belong to them.
class FileFlow : public QObject {
  Q_OBJECT

 public:
  FileFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent = nullptr);

  /// Each is true where it was done, false where it failed (the user was told why) or was cancelled.
  bool startNew();
  bool startWith(const Session& session);  ///< as a new session, in no file yet
  bool open();
  /// A session, a report with the session attached, or a file of readings to import.
  bool open(const QString& path);
  bool importReadings();
  /// The readings of files of instruments or tables, as the user wants them: into the session at work, or
  /// into a new one. Undone, the session is back as it was before, in its file.
  bool importReadings(const QStringList& paths);
  bool importClipboard();
  bool save();
  bool saveAs();
  /// Brings the session back as it is in its file, as one undo step. False: it was not, or has no file.
  bool revert();
  /// Seals the session and saves it. False: it was not sealed, or not saved.
  bool seal();
  bool exportReport();
  bool exportCertificate();
  bool printReport();
  bool previewReport();
  void setUpPage() { m_reports.setUpPage(); }
  /// Where others wrote the session's file: shows what differs, and does what the user wants.
  void settleChange();
  /// Other windows see in this folder which files are open here, and the other way round.
  void setLockFolder(const QString& folder);
  /// A check of the uncertainty, for reports of the session that it is of.
  void setBudgetCheck(const SharedBudgetCheck& check) { m_reports.setBudgetCheck(check); }
  /// May the session be left, and those that undo and redo lead to? Saves first where the user wants it.
  bool mayLeave();

 signals:
  void commitWanted();  ///< what is half typed belongs into the session before it is used
  void recentFilesChanged();
  void writing(bool is);             ///< the session into a file
  void remark(const QString& text);  ///< for the status line

 private:
  bool load(const QString& path);
  bool importFrom(const Result<std::vector<ImportSource>>& sources, const QString& name);
  bool loadAttached(const QString& path);
  bool saveTo(const QString& path);
  bool write(const QString& path);
  QStringList otherInputs() const;
  bool mayShare(const QString& path);
  std::optional<ChangedFileAnswer> askAboutChange();
  bool tellWhereNoFile(const QString& title, const QString& path);
  bool mayLeaveChanges();
  bool mayDropRedo();
  bool mayDropUndo();
  QString suggestedPath(const QString& suffix) const;

  SessionDocument& m_document;
  Dialogs& m_dialogs;
  FileLock m_lock;
  ReportFlow m_reports;
};

}  // namespace alidade::ui
