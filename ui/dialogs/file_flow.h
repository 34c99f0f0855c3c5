#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

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

/// Starts, opens, imports, saves, exports and closes sessions, and asks the user where necessary.
class FileFlow : public QObject {
  Q_OBJECT

 public:
  FileFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent = nullptr);

  /// Each function returns true on success, false if it failed (the user was told why) or was cancelled.
  bool startNew();
  bool startNext();                        ///< with the lasting entries of this session (`nextSession`)
  bool startWith(const Session& session);  ///< `session` becomes a new, unsaved session
  bool open();
  /// Opens a session, a report with an attached session, or a file of readings to import.
  bool open(const QString& path);
  bool importReadings();
  /// Imports readings of instrument files or tables into the current or a new session. Undo restores the
  /// previous session with its file.
  bool importReadings(const QStringList& paths);
  bool importClipboard();
  bool save();
  bool saveAs();
  /// Restores the session from its file, as one undo step. False: no file or no changes, or restoring failed.
  bool revert();
  /// Seals the session and saves it. False: the session was not sealed, or not saved.
  bool seal();
  bool exportReport();
  bool exportCertificate();
  bool printReport();
  bool previewReport();
  /// Shows the differences after another program changed the session's file, and does what the user chooses.
  void resolveChange();
  /// The folder in which windows register their open files for each other.
  void setLockFolder(const QString& folder);
  /// Stores a check of the uncertainty, for reports of its session.
  void setBudgetCheck(const SharedBudgetCheck& check) { m_reports.setBudgetCheck(check); }
  /// The number of readings that wait for the session: leaving the session asks about them.
  void setWaiting(std::function<std::size_t()> waiting) { m_waiting = std::move(waiting); }
  /// Asks whether the session, and the sessions to which undo and redo lead, may be left. Saves first if the
  /// user agrees.
  bool mayLeave();

 signals:
  void commitWanted();  ///< unfinished entries must be committed before the session is used
  void recentFilesChanged();
  /// Between true and false the session is written, compared or replaced: nothing else may change it, or take
  /// its file for changed by another program.
  void holding(bool is);
  void remark(const QString& text);  ///< for the status line

 private:
  auto held();
  bool load(const QString& path);
  bool importFrom(const Result<std::vector<ImportSource>>& sources, const QString& name);
  bool loadAttached(const QString& path);
  bool saveTo(const QString& path);
  bool write(const QString& path);
  QStringList otherInputs() const;
  bool mayShare(const QString& path);
  std::optional<ChangedFileAnswer> askAboutChange();
  bool isRefusedAsNonFile(const QString& title, const QString& path);
  bool mayLeaveChanges();
  bool mayDropRedo();
  bool mayDropUndo();
  QString suggestedPath(const QString& suffix) const;

  SessionDocument& m_document;
  Dialogs& m_dialogs;
  std::function<std::size_t()> m_waiting;
  FileLock m_lock;
  ReportFlow m_reports;
  int m_holds = 0;  ///< nested calls that hold the session
};

}  // namespace alidade::ui
