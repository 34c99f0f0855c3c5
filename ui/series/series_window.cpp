#include "ui/series/series_window.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QShortcut>
#include <QSplitter>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/failure.h"
#include "core/series/history/history_json.h"
#include "core/series/history/history_statement.h"
#include "core/series/history/series_file.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/written_file.h"
#include "ui/document/encoded_path.h"
#include "ui/panels/parts/frames.h"
#include "ui/report/device_history_report.h"
#include "ui/series/diagnosis_panel.h"
#include "ui/series/history_chart.h"
#include "ui/series/history_panel.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

enum Column {
  Date,
  Title,
  Instrument,
  DeviceName,
  Intersection,
  VerdictColumn,
  Condition,
  Trouble,
  ColumnCount
};

QString decoded(const std::string& path) {
  return QFile::decodeName(QByteArray::fromStdString(path));
}

QString named(const std::string& name, const std::string& serial) {
  const QString first = visibleLine(name), second = visibleLine(serial);
  if (first.isEmpty() || second.isEmpty()) return first + second;
  return listText({first, second});
}

QTableWidgetItem* cell(const QString& text, Qt::Alignment alignment = Qt::AlignLeft | Qt::AlignVCenter) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
  item->setTextAlignment(alignment);
  return item;
}

}  // namespace

SeriesWindow::SeriesWindow(Dialogs& dialogs, QWidget* parent)
    : QWidget(parent, Qt::Window),
      m_dialogs(dialogs),
      m_table(new QTableWidget),
      m_pages(new QTabWidget),
      m_history(new HistoryPanel),
      m_diagnosis(new DiagnosisPanel) {
  setWindowTitle(tr("Series — Alidade"));
  connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, &QWidget::close);
  m_pages->addTab(m_history, tr("&History"));
  m_pages->addTab(m_diagnosis, tr("&Shared Causes"));
  m_pages->setDocumentMode(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(createButtons());
  layout->addWidget(split(Qt::Vertical, "series parts", {createTable(), m_pages}, {220, 420}), 1);
  layout->addWidget(createFoot());
  const QSize frame(24, 64), usual(1080, 760);
  resize(usual.boundedTo(screen()->availableSize() - frame));
  connect(&m_job, &SeriesJob::finished, this, &SeriesWindow::take);
  connect(&m_job, &SeriesJob::progressed, this, [this](int done, int total) {
    m_progress->setRange(0, total);
    m_progress->setValue(std::max(done, m_progress->value()));
  });
  connect(m_history, &HistoryPanel::sessionStepped, this, &SeriesWindow::select);
  connect(m_history, &HistoryPanel::deviceChosen, this, &SeriesWindow::showWork);
  connect(m_history, &HistoryPanel::sessionWanted, this, [this](const std::string& file) {
    select(file);
    emit sessionWanted(decoded(file));
  });
  connect(&m_diagnosisJob, &SeriesDiagnosisJob::finished, this,
          [this](const std::shared_ptr<const SeriesAnswer>& answer) {
            if (m_diagnosisJob.isAtWork()) return;
            m_diagnosed = answer->files;
            m_diagnosis->setDiagnosis(answer->diagnosis, qText(answer->reason));
          });
  connect(m_diagnosis, &DiagnosisPanel::sessionWanted, this,
          [this](std::size_t file) { emit sessionWanted(decoded(m_diagnosed[file])); });
  connect(m_diagnosis, &DiagnosisPanel::keepWanted, this, [this](const OwnEffect& effect) {
    write(tr("Keep as an effect"), qText(effect.id), QStringLiteral("alidade-effect"),
          writeOwnEffect(effect));
  });
  for (ChartFiles* files : findChildren<ChartFiles*>())
    connect(files, &ChartFiles::fileWanted, this, [this](const ChartFile& file) {
      write(tr("Save chart"), file.chart, file.suffix, file.bytes.toStdString());
    });
  showSessions();
  showWork();
}

QWidget* SeriesWindow::createButtons() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const QString& text, const char* name, const QString& tip, auto slot) {
    auto* button = new QPushButton(text);
    button->setObjectName(QString::fromLatin1(name));
    button->setToolTip(tip);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, slot);
    layout->addWidget(button);
    return button;
  };
  add(tr("Add &Folder…"), "add folder", tr("All sessions (*.alidade) of a folder"), [this] { addFolder(); });
  add(tr("Add F&iles…"), "add files", tr("Single sessions, or a saved series"), [this] { addFiles(); });
  m_remove =
      add(tr("&Remove"), "remove", tr("Takes the selected sessions out of the series; their files stay"),
          [this] { removeSelected(); });
  m_save = add(tr("&Save Series…"), "save series",
               tr("Saves the list of these sessions and the baseline as a file that this window and "
                  "alidade-cli can open"),
               [this] { saveSeries(); });
  layout->addStretch();
  m_json = add(tr("Export &JSON…"), "export json", tr("The output of alidade-cli history --json"),
               [this] { exportJson(); });
  m_csv = add(tr("Export &CSV…"), "export csv", tr("The values of the quantity shown, with their limits"),
              [this] { exportCsv(); });
  m_pdf = add(tr("&PDF…"), "export pdf", tr("Exports the history of the device as a document"),
              [this] { exportPdf(); });
  return row;
}

QWidget* SeriesWindow::createTable() {
  m_table->setColumnCount(ColumnCount);
  m_table->setHorizontalHeaderLabels({tr("Date"), tr("Title"), tr("Instrument"), tr("Device"), tr("Δd ± U"),
                                      tr("Verdict"), tr("Condition"), tr("Problem")});
  m_table->setAccessibleName(tr("Sessions of the series"));
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setTabKeyNavigation(false);
  m_table->setAlternatingRowColors(true);
  m_table->setWordWrap(false);
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  m_table->horizontalHeader()->setHighlightSections(false);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->setToolTip(tr("Double click opens a session in the main window"));
  connect(m_table, &QTableWidget::itemSelectionChanged, this, &SeriesWindow::selectionChanged);
  connect(m_table, &QTableWidget::itemActivated, this,
          [this](QTableWidgetItem* item) { emit sessionWanted(fileOf(item->row())); });
  return m_table;
}

QWidget* SeriesWindow::createFoot() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  m_status = new QLabel;
  m_progress = new QProgressBar;
  m_progress->setFixedWidth(180);
  m_progress->setAccessibleName(tr("Sessions read"));
  m_stop = new QPushButton(tr("&Stop"));
  m_stop->setAutoDefault(false);
  connect(m_stop, &QPushButton::clicked, this, [this] {
    m_waiting.clear();
    m_job.stop();
  });
  layout->addWidget(m_status, 1);
  layout->addWidget(m_progress);
  layout->addWidget(m_stop);
  return row;
}

void SeriesWindow::addFolder() {
  const QString folder = m_dialogs.askFolder(tr("Add a folder of sessions"), m_folder);
  if (folder.isEmpty()) return;
  m_folder = folder;
  if (sessionPathsIn({folder}).empty()) {
    m_dialogs.showProblem(
        tr("Add a folder"),
        tr("%1 holds no session (*.alidade): choose another folder.").arg(visibleLine(folder)));
    return;
  }
  add({folder});
}

void SeriesWindow::addFiles() {
  const QStringList files = m_dialogs.askSessionPaths(m_folder);
  if (files.isEmpty()) return;
  m_folder = QFileInfo(files.first()).absolutePath();
  add(files);
}

void SeriesWindow::add(const QStringList& filesAndFolders) {
  for (const QString& path : filesAndFolders)
    if (isSeriesPath(encodedPath(path)))
      if (const auto series = loadSeriesFile(encodedPath(path)); series && series->baseline > 0)
        m_history->setBaseline(static_cast<int>(series->baseline));
  std::set<std::string> known;
  if (m_series)
    for (const SeriesSession& session : m_series->sessions) known.insert(session.path);
  for (const std::string& path : sessionPathsIn(filesAndFolders))
    if (!known.contains(path)) m_waiting.push_back(path);
  readNews();
}

void SeriesWindow::readNews() {
  const bool isNews = !m_waiting.empty() || (m_series && hasChangedFile(*m_series));
  if (isNews && !m_job.isAtWork()) {
    m_progress->setRange(0, static_cast<int>(m_waiting.size()));
    m_progress->setValue(0);
    m_job.start(m_series, std::exchange(m_waiting, {}));
  }
  showWork();
}

/// The user may return from a correction in the main window.
void SeriesWindow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::ActivationChange && isActiveWindow()) readNews();
}

void SeriesWindow::removeSelected() {
  if (!m_series || m_job.isAtWork()) return;
  const std::vector<std::string> gone = selectedFiles();
  Series left;
  for (const SeriesSession& session : m_series->sessions)
    if (std::ranges::find(gone, session.path) == gone.end()) left.sessions.push_back(session);
  m_job.start(std::make_shared<const Series>(std::move(left)), {});
  showWork();
}

void SeriesWindow::take(const SharedSeries& series) {
  m_series = series;
  showSessions();
  m_history->setSeries(m_series);
  if (!m_waiting.empty()) {
    std::set<std::string> known;
    for (const SeriesSession& session : m_series->sessions) known.insert(session.path);
    std::erase_if(m_waiting, [&](const std::string& path) { return known.contains(path); });
  }
  if (m_waiting.empty())
    diagnose();
  else
    m_job.start(m_series, std::exchange(m_waiting, {}));
  showWork();
}

/// Diagnoses the usable sessions together.
void SeriesWindow::diagnose() {
  std::vector<std::string> files;
  for (const SeriesSession& session : m_series->sessions)
    if (session.epoch) files.push_back(session.path);
  m_diagnosis->setDiagnosis(nullptr,
                            files.empty() ? QString() : tr("Looking for causes that the sessions share…"));
  m_diagnosisJob.start(files);
}

/// Shows the sessions in the order of their dates, undated sessions last.
void SeriesWindow::showSessions() {
  std::vector<const SeriesSession*> sessions;
  if (m_series)
    for (const SeriesSession& session : m_series->sessions) sessions.push_back(&session);
  std::ranges::stable_sort(sessions, {}, [](const SeriesSession* session) {
    const bool isDated = session->epoch && !session->epoch->date.empty();
    return std::pair(!isDated, isDated ? session->epoch->day : 0);
  });
  m_table->clearContents();
  m_table->setRowCount(static_cast<int>(sessions.size()));
  for (int row = 0; row < m_table->rowCount(); ++row) {
    const SeriesSession& session = *sessions[static_cast<std::size_t>(row)];
    const QString path = decoded(session.path);
    const auto set = [&](Column column, QTableWidgetItem* item) {
      item->setToolTip(tipText(
          column >= Condition && !item->text().isEmpty() ? item->text() : QDir::toNativeSeparators(path)));
      m_table->setItem(row, column, item);
    };
    const Epoch* epoch = session.epoch ? &*session.epoch : nullptr;
    const QString none;
    set(Date, cell(epoch ? visibleLine(epoch->date) : none));
    set(Title, cell(epoch ? visibleLine(epoch->title) : visibleLine(QFileInfo(path).fileName())));
    set(Instrument, cell(epoch ? named(epoch->instrument, epoch->instrumentSerial) : none));
    set(DeviceName, cell(epoch ? named(epoch->device, epoch->deviceSerial) : none));
    set(Intersection,
        cell(epoch ? qText(intersectionText(*epoch)) : none, Qt::AlignRight | Qt::AlignVCenter));
    set(VerdictColumn, cell(epoch ? qText(epoch->judgement.verdict) : none));
    set(Condition, cell(epoch ? qText(epoch->judgement.condition) : none));
    set(Trouble, cell(visibleLine(session.trouble)));
    m_table->item(row, Date)->setData(Qt::UserRole, path);
  }
  m_table->resizeColumnsToContents();
  constexpr int widest = 260;
  for (int column = 0; column < Trouble; ++column)
    m_table->setColumnWidth(column, std::clamp(m_table->columnWidth(column) + 8, 60, widest));
}

void SeriesWindow::showWork() {
  const bool isAtWork = m_job.isAtWork();
  const bool hasDevice = m_history->device() != nullptr;
  m_progress->setVisible(isAtWork);
  m_stop->setVisible(isAtWork);
  m_remove->setEnabled(!isAtWork && !m_table->selectedItems().isEmpty());
  m_save->setEnabled(!isAtWork && m_table->rowCount() > 0);
  m_json->setEnabled(hasDevice);
  m_csv->setEnabled(hasDevice);
  m_pdf->setEnabled(hasDevice);
  if (isAtWork) {
    m_status->setText(tr("Reading and diagnosing sessions…"));
    return;
  }
  const int sessions = m_table->rowCount();
  int troubled = 0;
  for (int row = 0; row < sessions; ++row) troubled += m_table->item(row, Trouble)->text().isEmpty() ? 0 : 1;
  m_status->setText(sessions == 0   ? tr("No sessions yet. Add a folder with the sessions of a device.")
                    : troubled == 0 ? tr("Sessions: %1").arg(sessions)
                                    : tr("Sessions: %1, of them not used: %2").arg(sessions).arg(troubled));
}

QString SeriesWindow::fileOf(int row) const {
  return m_table->item(row, Date)->data(Qt::UserRole).toString();
}

std::vector<std::string> SeriesWindow::selectedFiles() const {
  std::vector<std::string> files;
  for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
    files.push_back(encodedPath(fileOf(index.row())));
  return files;
}

void SeriesWindow::selectionChanged() {
  const std::vector<std::string> files = selectedFiles();
  m_history->compare(files);
  m_history->highlight(files.size() == 1 ? files.front() : std::string());
  showWork();
}

void SeriesWindow::select(const std::string& file) {
  for (int row = 0; row < m_table->rowCount(); ++row)
    if (encodedPath(fileOf(row)) == file) m_table->selectRow(row);
}

bool SeriesWindow::saveSeries() {
  if (!m_series || m_series->sessions.empty()) return false;
  const QString title = tr("Save series"), suffix = QStringLiteral("alidade-series");
  const QString path = m_dialogs.askExportPath(title, suggestedPath(tr("series"), suffix), suffix);
  if (path.isEmpty()) return false;
  SeriesFile series{.sessions = {}, .baseline = static_cast<std::size_t>(m_history->baseline())};
  std::vector<std::string> inputs = encodedPaths(m_dialogs.readFiles());
  for (const SeriesSession& session : m_series->sessions) {
    series.sessions.push_back(pathInSeries(session.path, encodedPath(path)));
    inputs.push_back(session.path);
  }
  if (const auto problem = writeFile(encodedPath(path), writeSeriesFile(series), inputs)) {
    m_dialogs.showProblem(title, visibleLine(problem->text()));
    return false;
  }
  m_status->setText(tr("Written to %1").arg(QDir::toNativeSeparators(path)));
  return true;
}

bool SeriesWindow::exportJson() {
  if (!m_history->device()) return false;
  const DeviceHistories histories{m_history->devices(), {}};
  std::vector<std::string> remarks;
  for (const SeriesSession& session : m_series->sessions)
    if (!session.trouble.empty()) remarks.push_back(session.path + ": " + session.trouble);
  return write(tr("Export history"), QStringLiteral("history"), QStringLiteral("json"),
               historyJson(deviceName(*m_history->device()), histories, remarks));
}

bool SeriesWindow::exportCsv() {
  if (!m_history->device()) return false;
  return write(tr("Export history"), QStringLiteral("history"), QStringLiteral("csv"),
               m_history->findChild<HistoryChart*>()->numbers());
}

bool SeriesWindow::exportPdf() {
  const DeviceHistory* device = m_history->device();
  if (!device) return false;
  const QString title = tr("Device history");
  const QString path = m_dialogs.askExportPath(
      title, suggestedPath(QStringLiteral("history"), QStringLiteral("pdf")), QStringLiteral("pdf"));
  if (path.isEmpty()) return false;
  std::optional<Result<QString>> written;
  const auto failure = failureOf([&] { written = writeDeviceHistory(*device, path, m_dialogs.readFiles()); });
  if (failure || !*written) {
    m_dialogs.showProblem(title, visibleLine(failure ? *failure : written->problem().text()));
    return false;
  }
  m_status->setText(tr("Written to %1").arg(QDir::toNativeSeparators(path)));
  return true;
}

bool SeriesWindow::write(const QString& title, const QString& what, const QString& suffix,
                         const std::string& bytes) {
  QStringList inputs;
  if (m_series)
    for (const SeriesSession& session : m_series->sessions)
      inputs.append(QFile::decodeName(QByteArray::fromStdString(session.path)));
  const auto path = writeToChosenPath(m_dialogs, title, suggestedPath(what, suffix), suffix, bytes, inputs);
  if (path) m_status->setText(tr("Written to %1").arg(QDir::toNativeSeparators(*path)));
  return path.has_value();
}

QString SeriesWindow::suggestedPath(const QString& what, const QString& suffix) const {
  const QDir folder = m_folder.isEmpty() ? QDir::home() : QDir(m_folder);
  return folder.filePath(what + u'.' + suffix);
}

}  // namespace alidade::ui
