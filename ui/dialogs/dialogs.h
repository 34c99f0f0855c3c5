#pragma once

#include <QFont>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "core/base/angle_text.h"
#include "core/session/own_effect.h"
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

/// The questions of the program. Virtual, so that tests can answer.
class Dialogs {
 public:
  enum class SaveAnswer { Save, Discard, Cancel };
  enum class Way { Undo, Redo };

  explicit Dialogs(QWidget* parent = nullptr) : m_parent(parent) {}
  virtual ~Dialogs() = default;

  /// The files read for this window. Writing must not replace any of them.
  QStringList readFiles() const { return m_readFiles ? m_readFiles() : QStringList(); }
  void setReadFiles(std::function<QStringList()> files) { m_readFiles = std::move(files); }

  /// What leaving a session would lose.
  struct Unsaved {
    QString name = {};        ///< of the session
    bool isModified = true;   ///< it has changes that its file lacks
    std::size_t waiting = 0;  ///< readings of the instrument that are not in the session yet
  };
  /// Offers Save only if the session is modified: saving does not take in waiting readings.
  virtual SaveAnswer askLeave(const Unsaved& unsaved);
  /// Asks whether undo or redo may discard the changes of another session. `name` is empty if that session
  /// was never saved.
  virtual bool askDiscardOther(const QString& name, Way way);
  /// Asks whether to delete the position called `name` with its typed sightings.
  virtual bool askDeletePosition(const QString& name, std::size_t sightings);
  /// Empty: cancelled.
  virtual QString askOpenPath(const QString& folder);
  virtual QStringList askImportPaths(const QString& folder);
  /// Asks how to import the readings; absent: cancelled.
  virtual std::optional<ImportDecision> askImport(ImportRequest request);
  /// Asks for an instrument record; empty: cancelled.
  virtual QString askRecordPath(const QString& folder);
  /// Asks for a measurement protocol; empty: cancelled.
  virtual QString askProtocolPath(const QString& folder);
  /// Edits the protocol in a form; absent: cancelled.
  virtual std::optional<SightingProtocol> askProtocol(const SightingProtocol& protocol, CircleUnit unit);
  /// Edits a user's own effect in a form; absent: cancelled.
  virtual std::optional<OwnEffect> askOwnEffect(const Session& session, const OwnEffect& effect);
  /// Asks for a folder, or single sessions, of a series; empty: cancelled.
  virtual QString askFolder(const QString& title, const QString& folder);
  virtual QStringList askSessionPaths(const QString& folder);
  virtual QString askSavePath(const QString& suggestion);
  virtual QString askReportPath(const QString& suggestion);
  /// `suffix`: "csv", "json", "svg" or "png".
  virtual QString askExportPath(const QString& title, const QString& suggestion, const QString& suffix);
  /// Asks for the contents and the paper of the report; absent: cancelled.
  virtual std::optional<ReportChoice> askReport(const ReportQuestion& question);
  /// False: cancelled.
  virtual bool askPaper(ReportPaper& paper);
  virtual bool askPrinter(QPrinter& printer, const QString& title);
  /// Shows what `paint` paints; returns what the user wants next.
  virtual PreviewAnswer showPreview(QPrinter& printer, const std::function<void(QPrinter&)>& paint,
                                    const PreviewChange& change);
  /// Asks who seals the session; empty: cancelled.
  virtual QString askSeal(const QString& suggestion);
  /// Asks whether to open or write a file that another window has open. `holder` names that window.
  virtual bool askOpenElsewhere(const QString& name, const QString& holder);
  virtual ChangedFileAnswer askChangedFile(const ChangedFile& file);
  virtual RecoveryAnswer askRecovery(const QList<RecoveryOffer>& offers);
  /// Edits and keeps the settings of the program; false: cancelled.
  virtual bool askPreferences();
  /// Asks for the font of the window; absent: cancelled.
  virtual std::optional<QFont> askFont(const QFont& now);
  virtual void showProblem(const QString& title, const QString& text);
  /// A waiting dialog for the operation named `doing`.
  virtual std::unique_ptr<Busy> busy(const QString& doing, Busy::Way way = Busy::Way::Stoppable);
  virtual void showAbout();
  virtual void showShortcuts();

 private:
  /// The parent of a question: an active non-modal child window of the main window, else the main window.
  QWidget* over() const;

  QPointer<QWidget> m_parent;
  std::function<QStringList()> m_readFiles;
};

}  // namespace alidade::ui
