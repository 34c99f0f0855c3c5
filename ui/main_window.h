#pragma once

#include <QMainWindow>
#include <memory>

#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/file_flow.h"
#include "ui/document/reading_column.h"
#include "ui/document/session_document.h"
#include "ui/recovery/file_watch.h"
#include "ui/window/session_jobs.h"

class QLabel;
class QStackedWidget;

namespace alidade::ui {

class ChangedFileBar;
class EntryColumn;
class EntryGuide;
class ExportFlow;
class InstrumentDesk;
class InstrumentFlow;
class JobStatus;
class PageTabs;
class ProtocolFlow;
class ReadingsTable;
class ResultColumn;
class Safekeeping;
class SideWindows;
class StartPage;
class WindowActions;

/// The main window. Creates its parts and connects them.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(std::unique_ptr<Dialogs> dialogs = nullptr);
  ~MainWindow() override;

  SessionDocument& document() { return m_document; }
  FileFlow& files() { return m_files; }
  ExportFlow& exports() { return *m_exports; }
  InstrumentFlow& instrument() { return *m_instrument; }
  FitJob& job() { return m_jobs.fit(); }
  GapJob& gapJob() { return m_jobs.gap(); }
  SessionJobs& jobs() { return m_jobs; }
  EntryColumn& entries() { return *m_entries; }
  EntryGuide& entry() { return *m_entry; }
  InstrumentDesk& instrumentDesk() { return *m_desk; }
  ResultColumn& results() { return *m_results; }
  SideWindows& sideWindows() { return *m_sideWindows; }
  ReadingsTable* currentTable() const;
  /// The tabs beside the picture of the arcs, then the tabs below the picture.
  QList<PageTabs*> pageTabs() const;

  /// Shows the entry at `place`: selects its tab and row, and focuses the entry if `takeFocus`.
  void reveal(const Place& place, bool takeFocus = true);
  /// Commits unfinished entries.
  void commitPending();
  void undo();
  void redo();
  /// Adds a position at `axisDeg` (0 or 180), or a repeat if 0° and 180° exist, and shows its pointing zero.
  void addPosition(int axisDeg);
  void setColumnShown(ReadingColumn column, bool shown);
  /// Keeps unsaved changes in `folder` from now on, and shows other windows which files are open.
  void keepIn(const QString& folder);
  /// Writes every unsaved change and unfinished entry before it returns; the process is about to end.
  void keepNow();
  /// Offers unsaved changes of a crashed window. False: there are none.
  bool offerRecovery();
  /// Shows the start page until a session is started, opened or changed.
  void showStart();
  void hideStart();
  /// Reports an exception of an event handler, and records it with the session.
  void reportFailure(const QString& reason);

 protected:
  void changeEvent(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void createStatusBar();
  void connectColumns();
  void connectJobs();
  void connectEntry();
  void connectFile();
  void showFileState(FileState state);
  void createStart();
  void openSample(const QString& name);
  QStringList readFiles() const;
  void showTitle();
  void say(const QString& text, int milliseconds = 8000);

  std::unique_ptr<Dialogs> m_dialogs;
  SessionDocument m_document;
  FileFlow m_files;
  ExportFlow* m_exports;
  InstrumentFlow* m_instrument;
  ProtocolFlow* m_protocol;
  FileWatch m_watch;
  Safekeeping* m_safekeeping = nullptr;  ///< null until `keepIn`
  SessionJobs m_jobs;
  Place m_lastChange;
  InstrumentDesk* m_desk;
  EntryColumn* m_entries;
  ResultColumn* m_results;
  SideWindows* m_sideWindows;
  ChangedFileBar* m_changedFile;
  QStackedWidget* m_stack;       ///< the current session, or the start page
  StartPage* m_start = nullptr;  ///< null until first shown
  WindowActions* m_actions;
  EntryGuide* m_entry;
  JobStatus* m_jobStatus;
  QLabel* m_next;  ///< the next reading, in the status bar
};

}  // namespace alidade::ui
