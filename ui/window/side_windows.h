#pragma once

#include <QObject>

namespace alidade::ui {

class BlindTrialDialog;
class Dialogs;
class ExportFlow;
class FileFlow;
class InstallationDialog;
class InstrumentDialog;
class RecordHistoryDialog;
class SeriesWindow;

/// The windows that stay open next to the main one. Each is created when first shown.
class SideWindows : public QObject {
  Q_OBJECT

 public:
  SideWindows(Dialogs& dialogs, FileFlow& files, ExportFlow& exports, QWidget& window);

  void showBlindTrials();
  void showInstrumentCheck();
  void showInstallationCheck();
  void showRecordHistory();
  void showSeries();
  /// Shows the sessions of a `*.alidade-series` file.
  void openSeries(const QString& path);
  /// The files read for the instrument check.
  QStringList readFiles() const;

 signals:
  void trialOpened();  ///< a blind trial is the current session now

 private:
  Dialogs& m_dialogs;
  FileFlow& m_files;
  ExportFlow& m_exports;
  QWidget& m_window;
  BlindTrialDialog* m_blindTrials = nullptr;
  InstallationDialog* m_installationCheck = nullptr;
  InstrumentDialog* m_instrumentCheck = nullptr;
  RecordHistoryDialog* m_records = nullptr;
  SeriesWindow* m_series = nullptr;
};

}  // namespace alidade::ui
