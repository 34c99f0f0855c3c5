#include "ui/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QUrl>
#include <utility>

#include "core/base/phrase.h"
#include "core/base/version.h"
#include "ui/commands/change_positions.h"
#include "ui/connection/instrument_desk.h"
#include "ui/dialogs/export_flow.h"
#include "ui/dialogs/instrument_flow.h"
#include "ui/dialogs/protocol_flow.h"
#include "ui/dialogs/safekeeping.h"
#include "ui/entry/entry_guide.h"
#include "ui/jobs/failed_job.h"
#include "ui/main_window_actions.h"
#include "ui/panels/parts/frames.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/window/changed_file_bar.h"
#include "ui/panels/window/job_status.h"
#include "ui/report/report_choice.h"
#include "ui/start/samples.h"
#include "ui/start/start_page.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"
#include "ui/window/entry_column.h"
#include "ui/window/result_column.h"
#include "ui/window/side_windows.h"
#include "ui/window/window_layout.h"

namespace alidade::ui {

namespace {

/// The local paths of the URLs in `data`; empty if any URL is not a local file.
QStringList filesIn(const QMimeData& data) {
  QStringList paths;
  for (const QUrl& url : data.urls()) {
    if (!url.isLocalFile()) return {};
    paths.append(url.toLocalFile());
  }
  return paths;
}

}  // namespace

MainWindow::MainWindow(std::unique_ptr<Dialogs> dialogs)
    : m_dialogs(dialogs ? std::move(dialogs) : std::make_unique<Dialogs>(this)),
      m_files(m_document, *m_dialogs),
      m_exports(new ExportFlow(m_document, *m_dialogs, this)),
      m_instrument(new InstrumentFlow(m_document, *m_dialogs, this)),
      m_protocol(new ProtocolFlow(m_document, *m_dialogs, this)),
      m_watch(m_document),
      m_jobs(m_document),
      m_desk(new InstrumentDesk(m_document, *m_dialogs, m_jobs.fit(), *this)),
      m_entries(new EntryColumn(m_document, m_jobs, *m_desk, *this)),
      m_results(new ResultColumn({m_document, m_jobs, *m_dialogs, m_files, *m_exports, *m_instrument,
                                  *m_protocol, m_entries->positions()},
                                 *this)),
      m_sideWindows(new SideWindows(*m_dialogs, m_files, *m_exports, *this)),
      m_changedFile(new ChangedFileBar),
      m_stack(new QStackedWidget) {
  QSplitter* columns =
      split(Qt::Horizontal, "columns", {m_entries->widget(), m_results->widget()}, {518, 762});
  m_stack->addWidget(stacked(m_changedFile, columns));
  setCentralWidget(m_stack);
  m_actions = new WindowActions(*this, *m_dialogs);
  m_entry = new EntryGuide(m_document, m_entries->positions(), *this);
  createStatusBar();
  setAcceptDrops(true);
  m_dialogs->setReadFiles([this] { return readFiles(); });
  resize(firstSize(*this));
  connectColumns();
  connectJobs();
  connectEntry();
  connectFile();
  restoreLayout(*this);
  showTitle();
  m_entry->goToNextEntry();
}

MainWindow::~MainWindow() {
  delete m_safekeeping;
  m_document.disconnect();
  m_document.undoStack().disconnect();
  m_document.halfTyped().disconnect();
  m_jobs.disconnect();
  m_jobs.fit().disconnect();
  m_jobs.gap().disconnect();
  delete takeCentralWidget();
}

void MainWindow::createStatusBar() {
  m_jobStatus = new JobStatus(m_jobs.fit(), m_jobs.gap());
  m_next = new QLabel;
  m_next->setObjectName(QStringLiteral("next reading"));
  for (QWidget* part : std::initializer_list<QWidget*>{m_desk->status(), m_next, m_jobStatus})
    statusBar()->addPermanentWidget(part);
}

void MainWindow::say(const QString& text, int milliseconds) {
  statusBar()->showMessage(visibleLine(text), milliseconds);
}

/// The files that no output may overwrite: of the session, of the instrument check, and the logo of reports.
QStringList MainWindow::readFiles() const {
  QStringList files = m_document.paths() + m_document.readPaths() + m_sideWindows->readFiles();
  if (const QString logo = rememberedReportChoice().logoPath; !logo.isEmpty()) files.append(logo);
  return files;
}

void MainWindow::connectColumns() {
  PositionTabs& positions = m_entries->positions();
  connect(m_entries, &EntryColumn::commitWanted, this, &MainWindow::commitPending);
  connect(m_entries, &EntryColumn::revealWanted, this, &MainWindow::reveal);
  connect(m_results, &ResultColumn::commitWanted, this, &MainWindow::commitPending);
  connect(m_results, &ResultColumn::revealWanted, this, &MainWindow::reveal);
  const auto showGap = [this] { m_results->showPage("gap"); };
  connect(m_entries, &EntryColumn::gapWanted, this, showGap);
  connect(m_sideWindows, &SideWindows::trialOpened, this, showGap);
  connect(&positions, &PositionTabs::remark, this, [this](const QString& text) { say(text); });
  connect(&positions, &PositionTabs::positionWanted, this, &MainWindow::addPosition);
  connect(&positions, &PositionTabs::tableCreated, m_actions, &WindowActions::attachTo);
  for (std::size_t i = 0; positions.table(i); ++i) m_actions->attachTo(positions.table(i));
}

void MainWindow::connectJobs() {
  connect(&m_document, &SessionDocument::changed, this,
          [this](const SessionChange& change) { m_lastChange = change.place; });
  connect(&m_jobs, &SessionJobs::begun, m_jobStatus, &JobStatus::watch);
  connect(&m_jobs, &SessionJobs::searchStopped, this,
          [this] { say(tr("The search for misread readings was stopped.")); });
  connect(m_jobStatus, &JobStatus::stopWanted, &m_jobs, &SessionJobs::stop);
  connect(&m_jobs, &SessionJobs::evaluated, m_entry, &EntryGuide::setEvaluation);
  connect(&m_jobs, &SessionJobs::headlineChanged, m_entry, &EntryGuide::setHeadline);
  m_jobs.start();
}

/// Connects everything that moves the keyboard focus to the next entry, including instrument readings.
void MainWindow::connectEntry() {
  connect(m_entry, &EntryGuide::commitWanted, this, &MainWindow::commitPending);
  connect(m_entry, &EntryGuide::revealWanted, this, [this](const Place& place) { reveal(place); });
  connect(m_entry, &EntryGuide::positionWanted, this, &MainWindow::addPosition);
  connect(m_entry, &EntryGuide::nextChanged, m_next, &QLabel::setText);
  const auto sayLong = [this](const QString& text) { say(text, 15000); };
  connect(m_entry, &EntryGuide::remark, this, sayLong);
  connect(m_desk, &InstrumentDesk::remark, this, sayLong);
  connect(m_desk, &InstrumentDesk::landed, this, [this](const Place& place) { reveal(place, false); });
  connect(&m_document, &SessionDocument::changed, this, [this](const SessionChange& change) {
    if (change.kind != SessionChange::Kind::Everything) return;
    const auto [tabs, index] = m_results->tab("result");
    tabs->setCurrentIndex(index);  // shows the verdict
    m_entry->goToNextEntry();
  });
}

void MainWindow::connectFile() {
  const auto serve = [this]<typename Flow>(Flow* flow) {
    connect(flow, &Flow::commitWanted, this, &MainWindow::commitPending);
    connect(flow, &Flow::remark, this, [this](const QString& text) { say(text); });
  };
  serve(&m_files);
  serve(m_exports);
  serve(m_instrument);
  serve(m_protocol);
  m_files.setWaiting([this] { return m_desk->flow().waiting(); });
  connect(&m_document, &SessionDocument::identityChanged, this, &MainWindow::showTitle);
  connect(&m_document.halfTyped(), &HalfTyped::changed, this, &MainWindow::showTitle);
  connect(&m_watch, &FileWatch::stateChanged, this, &MainWindow::showFileState);
  connect(&m_files, &FileFlow::holding, &m_watch, &FileWatch::setHeld);
  connect(&m_files, &FileFlow::holding, m_desk, &InstrumentDesk::setHeld);
  connect(m_changedFile, &ChangedFileBar::comparisonWanted, &m_files, &FileFlow::resolveChange);
  connect(m_changedFile, &ChangedFileBar::saveWanted, &m_files, &FileFlow::save);
}

void MainWindow::showFileState(FileState state) {
  if (state == FileState::Known) return m_changedFile->hide();
  if (state == FileState::Changed) return m_changedFile->showChanged(m_document.displayName());
  m_document.markFileGone();
  m_changedFile->showMissing(m_document.displayName());
}

void MainWindow::createStart() {
  m_start = new StartPage;
  m_stack->addWidget(m_start);
  connect(m_start, &StartPage::newWanted, &m_files, [this] { m_files.startNew(); });
  connect(m_start, &StartPage::openWanted, &m_files, [this] { m_files.open(); });
  connect(m_start, &StartPage::importWanted, &m_files, [this] { m_files.importReadings(); });
  connect(m_start, &StartPage::fileWanted, &m_files, [this](const QString& path) { m_files.open(path); });
  connect(m_start, &StartPage::guideWanted, m_actions, &WindowActions::showFirstSteps);
  connect(m_start, &StartPage::sampleWanted, this, &MainWindow::openSample);
  connect(m_start, &StartPage::sessionWanted, this, [this](const QString& typed) {
    hideStart();
    if (QWidget* entry = focusWidget(); entry && !typed.isEmpty()) {
      QKeyEvent press(QEvent::KeyPress, 0, Qt::NoModifier, typed);
      QApplication::sendEvent(entry, &press);
    }
  });
  connect(&m_document, &SessionDocument::changed, m_start, [this] { hideStart(); });
}

void MainWindow::openSample(const QString& name) {
  if (const Result<Session> sample = readSample(name))
    m_files.startWith(*sample);
  else
    m_dialogs->showProblem(tr("Open sample"), visibleLine(sample.problem().text()));
}

void MainWindow::showStart() {
  if (!m_start) createStart();
  m_start->refresh();
  m_stack->setCurrentWidget(m_start);
  m_start->focusFirst();
  m_next->hide();
}

/// Shows the session again and goes to its next entry.
void MainWindow::hideStart() {
  if (!m_start || m_stack->currentWidget() != m_start) return;
  m_stack->setCurrentIndex(0);
  m_next->show();
  m_entry->goToNextEntry();
}

void MainWindow::keepIn(const QString& folder) {
  m_files.setLockFolder(folder);
  m_safekeeping = new Safekeeping(m_document, m_files, *m_dialogs, folder, this);
  statusBar()->insertPermanentWidget(0, m_safekeeping->trouble());
  connect(m_safekeeping, &Safekeeping::remark, this, [this](const QString& text) { say(text); });
}

void MainWindow::keepNow() {
  if (m_safekeeping) m_safekeeping->keepNow();
}

bool MainWindow::offerRecovery() {
  return m_safekeeping && m_safekeeping->offer() > 0;
}

void MainWindow::reportFailure(const QString& reason) {
  const std::string text = ui::reportFailure({.job = PHRASE_LATER("Phrase", "window"),
                                              .reason = reason.toStdString(),
                                              .session = m_document.session()});
  m_dialogs->showProblem(tr("Something went wrong"), qText(text));
}

void MainWindow::showTitle() {
  const QString mark = QStringLiteral("[*]");
  QString name = visibleLine(m_document.displayName());
  name.replace(mark, mark + mark);  // escapes a “[*]” in the name itself
  // The title ends in the program's name, which Qt would add otherwise.
  if (const auto seal = sealOf(m_document.session().journal))
    name = (changesSince(*seal, m_document.session().journal) == 0 ? tr("%1 (sealed)")
                                                                   : tr("%1 (changed since the seal)"))
               .arg(name);
  setWindowTitle(QStringLiteral("%1[*] — %2 — Alidade").arg(name, qText(versionAndBuild())));
  setWindowModified(m_document.isModified() || !m_document.halfTyped().isEmpty());
}

ReadingsTable* MainWindow::currentTable() const {
  return m_entries->positions().currentTable();
}

QList<PageTabs*> MainWindow::pageTabs() const {
  return m_results->tabs();
}

void MainWindow::setColumnShown(ReadingColumn column, bool shown) {
  m_entries->positions().setColumnShown(column, shown);
}

void MainWindow::reveal(const Place& place, bool takeFocus) {
  if (m_results->reveal(place, takeFocus)) return;
  if (place.position && place.reading && m_entries->positions().table(*place.position)) hideStart();
  m_entries->reveal(place, takeFocus);
}

void MainWindow::commitPending() {
  m_entries->commit();
  m_results->commit();
}

void MainWindow::undo() {
  commitPending();
  m_document.undoStack().undo();
  reveal(m_lastChange, false);
}

void MainWindow::redo() {
  commitPending();
  m_document.undoStack().redo();
  reveal(m_lastChange, false);
}

void MainWindow::addPosition(int axisDeg) {
  commitPending();
  if (!mayAddPosition(m_document.session(), axisDeg)) return;
  ui::addPosition(m_document, axisDeg);
  reveal({.position = m_lastChange.position, .field = "pointing_zero.horizontal"});
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::ActivationChange && isActiveWindow()) m_watch.look();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!m_files.mayLeave()) {
    event->ignore();
    return;
  }
  if (m_safekeeping) m_safekeeping->finish();
  m_results->setPictureShown(true);
  saveLayout(*this);
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!filesIn(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  const QStringList paths = filesIn(*event->mimeData());
  paths.size() == 1 ? m_files.open(paths.first()) : m_files.importReadings(paths);
}

}  // namespace alidade::ui
