#pragma once

#include <QWidget>

#include "ui/jobs/series_job.h"
#include "ui/series/diagnosis_job.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTabWidget;
class QTableWidget;

namespace alidade::ui {

class Dialogs;
class HistoryPanel;

/// A separate window for the sessions of one or several devices together: their table, with pages of results
/// below.
class SeriesWindow : public QWidget {
  Q_OBJECT

 public:
  explicit SeriesWindow(Dialogs& dialogs, QWidget* parent = nullptr);

  SeriesJob& job() { return m_job; }
  SeriesDiagnosisJob& diagnosisJob() { return m_diagnosisJob; }
  QTabWidget* pages() const { return m_pages; }
  HistoryPanel* history() const { return m_history; }
  DiagnosisPanel* diagnosis() const { return m_diagnosis; }
  QTableWidget* table() const { return m_table; }
  const SharedSeries& series() const { return m_series; }

  void addFolder();  ///< asks for the folder
  void addFiles();
  void add(const QStringList& filesAndFolders);
  void removeSelected();
  /// Asks for a file, and writes the baseline and the paths of the sessions relative to that file.
  bool saveSeries();
  bool exportJson();
  bool exportCsv();
  bool exportPdf();

 signals:
  /// Asks the main window to open this session.
  void sessionWanted(const QString& path);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* createButtons();
  QWidget* createTable();
  QWidget* createFoot();
  void readNews();  ///< reads the waiting files and those that have changed
  void take(const SharedSeries& series);
  void diagnose();
  void showSessions();
  void showWork();
  void selectionChanged();
  std::vector<std::string> selectedFiles() const;
  void select(const std::string& file);
  QString fileOf(int row) const;
  bool write(const QString& title, const QString& what, const QString& suffix, const std::string& bytes);
  QString suggestedPath(const QString& what, const QString& suffix) const;

  Dialogs& m_dialogs;
  SeriesJob m_job;
  SeriesDiagnosisJob m_diagnosisJob;
  SharedSeries m_series;
  QString m_folder;                      ///< the folder visited last
  std::vector<std::string> m_diagnosed;  ///< files in the order of the diagnosis
  std::vector<std::string> m_waiting;    ///< to be added after the running work
  QTableWidget* m_table;
  QTabWidget* m_pages;
  HistoryPanel* m_history;
  DiagnosisPanel* m_diagnosis;
  QProgressBar* m_progress;
  QLabel* m_status;
  QPushButton *m_stop, *m_remove, *m_save, *m_json, *m_csv, *m_pdf;
};

}  // namespace alidade::ui
