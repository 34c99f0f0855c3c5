#pragma once

#include <QMainWindow>
#include <memory>

#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/file_flow.h"
#include "ui/document/reading_column.h"
#include "ui/document/session_document.h"
#include "ui/jobs/fit_job.h"
#include "ui/jobs/gap_job.h"
#include "ui/recovery/file_watch.h"

class QLabel;
class QSplitter;
class QStackedWidget;
class QTabWidget;

namespace alidade::ui {

class ArcChart;
class BlindTrialDialog;
class InstallationDialog;
class InstrumentDesk;
class InstrumentDialog;
class BudgetPanel;
class ChangedFileBar;
class EffectsPanel;
class EntryGuide;
class ExportFlow;
class InstrumentFlow;
class FindingsPanel;
class GapPanel;
class JobStatus;
class JournalPanel;
class KnownSizesPanel;
class OrderPanel;
class PageTabs;
class PositionTabs;
class ProtocolFlow;
class ReadingsFinder;
class ReadingsTable;
class ResultPanel;
class Safekeeping;
class SeriesWindow;
class StartPage;
class SuspectBar;
class WindowActions;
struct Headline;

/// The workstation's window: connects its parts, which do the work.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(std::unique_ptr<Dialogs> dialogs = nullptr);
  ~MainWindow() override;

  SessionDocument& document() { return m_document; }
  FileFlow& files() { return m_files; }
  ExportFlow& exports() { return *m_exports; }
  InstrumentFlow& instrument() { return *m_instrument; }
  FitJob& job() { return m_job; }
  FitJob& fitJob() { return m_job; }
  GapJob& gapJob() { return m_gapJob; }
  EntryGuide& entry() { return *m_entry; }
  InstrumentDesk& instrumentDesk() { return *m_desk; }
  ReadingsFinder& finder() { return *m_finder; }
  ReadingsTable* currentTable() const;

  /// Leads to an entry: its tab, its row, and the focus if `takeFocus`.
  void reveal(const Place& place, bool takeFocus = true);
  /// Commits unfinished entries.
  void commitPending();
  void undo();
  void redo();
  /// Adds a position at `axisDeg` (0 or 180), a repeat if both exist, and leads to its pointing zero.
  void addPosition(int axisDeg);
  /// Removes the position in front.
  void removePosition();
  /// Moves the selected readings to the next position.
  void moveReadings();
  void setColumnShown(ReadingColumn column, bool shown);
  /// Gives the room of the picture to the pages below it.
  void setDetailsEnlarged(bool enlarged);
  /// Keeps unsaved changes in `folder` from now on, and shows other windows which files are open.
  void keepIn(const QString& folder);
  /// Keeps everything unsaved or unfinished before it returns, since the process is about to end.
  void keepNow();
  /// Offers unsaved changes of a crashed window. False: there are none.
  bool offerRecovery();
  /// Shows the start page until there is a session.
  void showStart();
  void hideStart();
  /// Opens the dialog of blind trials, which stays open next to the window.
  void showBlindTrials();
  /// Opens the dialog of the instrument check, which stays open next to the window.
  void showInstrumentCheck();
  void showInstallationCheck();
  /// Opens the window of series, which stays open next to this one.
  void showSeries();
  /// Reports an exception of an event handler, and records it with the session.
  void tellFailure(const QString& reason);
  SuspectBar* suspects() const { return m_suspects; }
  /// The tabs at the right of the picture of the arcs and below it.
  QList<PageTabs*> pageTabs() const { return {m_figures, m_details}; }

 protected:
  void changeEvent(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* createEntryColumn();
  QWidget* createResultColumn();
  PageTabs* createFigures();
  PageTabs* createDetails();
  void connectParts();
  void connectEntry();
  void connectInstrument();
  void connectSuspects();
  void connectGap();
  void connectFile();
  void connectCharts();
  void createStart();
  void excludeRow(const Place& place);
  void selectReading(std::size_t position, std::size_t row);
  QStringList readFiles() const;
  void showTitle();
  void showEvaluation(const SharedEvaluation& evaluation);
  void showSuspects(const SharedEvaluation& evaluation);
  void showHeadline(const Headline& headline);
  void showGap(const SharedGap& gap);
  void showGapAsOld();
  /// Asks for an effect of one's own, starting with `effect`, and keeps it in the session.
  void typeOwnEffect(const OwnEffect& effect);
  void showNoGap();
  void stopJobs();
  void markForms();
  void revealField(const Place& place, bool takeFocus);
  QSize firstSize() const;
  void fitOnScreen();
  bool isNarrow() const;
  bool isLow() const;
  void restoreLayout();
  void saveLayout() const;

  std::unique_ptr<Dialogs> m_dialogs;
  SessionDocument m_document;
  FileFlow m_files;
  ExportFlow* m_exports;
  InstrumentFlow* m_instrument;
  ProtocolFlow* m_protocol;
  FileWatch m_watch;
  Safekeeping* m_safekeeping = nullptr;  ///< null until `keepIn`
  FitJob m_job;
  GapJob m_gapJob;
  Place m_lastChange;
  bool m_isGapOld = false;  ///< the diagnosis shown belongs to an earlier state
  WindowActions* m_actions = nullptr;
  QStackedWidget* m_stack = nullptr;  ///< the current session, or the start page
  StartPage* m_start = nullptr;       ///< null until first shown
  ChangedFileBar* m_changedFile = nullptr;
  QTabWidget* m_forms = nullptr;
  PositionTabs* m_positions = nullptr;
  SuspectBar* m_suspects = nullptr;
  FindingsPanel* m_findings = nullptr;
  ArcChart* m_arcChart = nullptr;
  QSplitter* m_top = nullptr;     ///< the picture and the pages at its right
  PageTabs* m_figures = nullptr;  ///< at the right of the picture: narrow pages of figures
  PageTabs* m_details = nullptr;  ///< below it: charts and tables of single readings
  EffectsPanel* m_effects = nullptr;
  KnownSizesPanel* m_known = nullptr;
  ResultPanel* m_result = nullptr;
  BudgetPanel* m_budget = nullptr;
  GapPanel* m_gap = nullptr;
  JournalPanel* m_journal = nullptr;
  OrderPanel* m_order = nullptr;
  JobStatus* m_jobs = nullptr;
  QLabel* m_next = nullptr;  ///< the next reading, in the status bar
  EntryGuide* m_entry = nullptr;
  InstrumentDesk* m_desk;
  ReadingsFinder* m_finder = nullptr;
  SharedEvaluation m_shown;                           ///< the newest; null before the first
  BlindTrialDialog* m_blindTrials = nullptr;          ///< null until first shown
  InstallationDialog* m_installationCheck = nullptr;  ///< likewise
  InstrumentDialog* m_instrumentCheck = nullptr;      ///< likewise
  SeriesWindow* m_series = nullptr;                   ///< likewise
};

}  // namespace alidade::ui
