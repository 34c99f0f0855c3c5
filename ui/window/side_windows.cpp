#include "ui/window/side_windows.h"

#include "ui/dialogs/blind_trial_dialog.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/export_flow.h"
#include "ui/dialogs/file_flow.h"
#include "ui/instrument/check_chart.h"
#include "ui/instrument/check_input.h"
#include "ui/instrument/instrument_dialog.h"
#include "ui/self_test/installation_dialog.h"
#include "ui/series/record_history_dialog.h"
#include "ui/series/series_window.h"

namespace alidade::ui {

namespace {

void putInFront(QWidget* window) {
  window->show();
  window->raise();
  window->activateWindow();
}

}  // namespace

SideWindows::SideWindows(Dialogs& dialogs, FileFlow& files, ExportFlow& exports, QWidget& window)
    : QObject(&window), m_dialogs(dialogs), m_files(files), m_exports(exports), m_window(window) {}

void SideWindows::showBlindTrials() {
  if (!m_blindTrials) {
    m_blindTrials = new BlindTrialDialog(&m_window);
    connect(m_blindTrials, &BlindTrialDialog::sessionWanted, this, [this](const Session& session) {
      if (m_files.startWith(session)) emit trialOpened();
    });
  }
  putInFront(m_blindTrials);
}

void SideWindows::showInstrumentCheck() {
  if (!m_instrumentCheck) {
    m_instrumentCheck = new InstrumentDialog(m_dialogs, &m_window);
    connect(&m_instrumentCheck->chart().files(), &ChartFiles::fileWanted, &m_exports, &ExportFlow::saveChart);
  }
  putInFront(m_instrumentCheck);
}

void SideWindows::showInstallationCheck() {
  if (!m_installationCheck) m_installationCheck = new InstallationDialog(m_dialogs, &m_window);
  putInFront(m_installationCheck);
}

void SideWindows::showRecordHistory() {
  if (!m_records) m_records = new RecordHistoryDialog(m_dialogs, &m_window);
  putInFront(m_records);
}

void SideWindows::showSeries() {
  if (!m_series) {
    m_series = new SeriesWindow(m_dialogs, &m_window);
    connect(m_series, &SeriesWindow::sessionWanted, this, [this](const QString& path) {
      if (m_files.open(path)) m_window.activateWindow();
    });
  }
  putInFront(m_series);
}

void SideWindows::openSeries(const QString& path) {
  showSeries();
  m_series->add({path});
}

QStringList SideWindows::readFiles() const {
  return m_instrumentCheck ? m_instrumentCheck->input().paths() : QStringList();
}

}  // namespace alidade::ui
