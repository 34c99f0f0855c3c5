#pragma once

#include <QFont>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "core/base/circle_unit.h"
#include "core/session/sighting_protocol.h"
#include "ui/dialogs/busy.h"
#include "ui/dialogs/changed_file.h"
#include "ui/dialogs/print_preview.h"
#include "ui/dialogs/recovery_dialog.h"
#include "ui/dialogs/report_dialog.h"

class QPrinter;

namespace alidade::ui {

struct ImportDecision;
struct ImportRequest;

/// The questions the program asks. Virtual, so that tests can answer.
class Dialogs {
 public:
  enum class SaveAnswer { Save, Discard, Cancel };
  enum class Way { Undo, Redo };

  explicit Dialogs(QWidget* parent = nullptr) : m_parent(parent) {}
  virtual ~Dialogs() = default;

  /// The files that were read for this window. Nothing that is written may replace one of them.
  QStringList readFiles() const { return m_readFiles ? m_readFiles() : QStringList(); }
  void setReadFiles(std::function<QStringList()> files) { m_readFiles = std::move(files); }

  virtual SaveAnswer askSaveChanges(const QString& name);
  /// Shall the changes of another session be lost, which undo or redo leads to? `name` is empty where it was
  /// never saved.
  virtual bool askDiscardOther(const QString& name, Way way);
  /// Empty: cancelled.
  virtual QString askOpenPath(const QString& folder);
  virtual QStringList askImportPaths(const QString& folder);
  /// How the readings are to be taken; absent: cancelled.
  virtual std::optional<ImportDecision> askImport(ImportRequest request);
  /// Of an instrument record; empty: cancelled.
  virtual QString askRecordPath(const QString& folder);
  /// Of a measurement protocol; empty: cancelled.
  virtual QString askProtocolPath(const QString& folder);
  /// The protocol in a form; absent: cancelled.
  virtual std::optional<SightingProtocol> askProtocol(const SightingProtocol& protocol, CircleUnit unit);
  /// A folder, and sessions one by one, of a series; empty: cancelled.
  virtual QString askFolder(const QString& title, const QString& folder);
  virtual QStringList askSessionPaths(const QString& folder);
  virtual QString askSavePath(const QString& suggestion);
  virtual QString askReportPath(const QString& suggestion);
  /// `suffix`: "csv", "json", "svg" or "png".
  virtual QString askExportPath(const QString& title, const QString& suggestion, const QString& suffix);
  /// What the report shall hold, and on which paper; absent: cancelled.
  virtual std::optional<ReportChoice> askReport(const ReportQuestion& question);
  /// False: cancelled.
  virtual bool askPaper(ReportPaper& paper);
  virtual bool askPrinter(QPrinter& printer);
  /// Shows what `paint` paints; answers with what is wanted next.
  virtual PreviewAnswer showPreview(QPrinter& printer, const std::function<void(QPrinter&)>& paint);
  /// Who seals the session; empty: cancelled.
  virtual QString askSeal(const QString& suggestion);
  /// Shall a file be opened, or be written to, that another window has open? `holder` says which.
  virtual bool askOpenElsewhere(const QString& name, const QString& holder);
  virtual ChangedFileAnswer askChangedFile(const ChangedFile& file);
  virtual RecoveryAnswer askRecovery(const QList<RecoveryOffer>& offers);
  /// The letters of the window; absent: cancelled.
  virtual std::optional<QFont> askFont(const QFont& now);
  virtual void showProblem(const QString& title, const QString& text);
  /// To wait with, while `doing` is done.
  virtual std::unique_ptr<Busy> busy(const QString& doing, Busy::Way way = Busy::Way::Stoppable);
  virtual void showAbout();
  virtual void showShortcuts();

 private:
  /// What a question stands over: a window beside the main one where that is at work.
  QWidget* over() const;

  QPointer<QWidget> m_parent;
  std::function<QStringList()> m_readFiles;
};

}  // namespace alidade::ui
