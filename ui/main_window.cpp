#include "ui/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>
#include <QUrl>
#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/version.h"
#include "core/diagnosis/kept_form.h"
#include "core/session/entry.h"
#include "core/session/own_effects.h"
#include "ui/charts/arc/arc_chart.h"
#include "ui/charts/arc/arc_plot.h"
#include "ui/charts/residuals/residual_chart.h"
#include "ui/commands/add_position.h"
#include "ui/commands/apply_changes.h"
#include "ui/commands/change_effects.h"
#include "ui/commands/change_field.h"
#include "ui/commands/change_own_effects.h"
#include "ui/commands/edit_readings.h"
#include "ui/commands/move_rows.h"
#include "ui/commands/remove_position.h"
#include "ui/commands/state_noise.h"
#include "ui/connection/instrument_desk.h"
#include "ui/connection/reading_question_bar.h"
#include "ui/dialogs/blind_trial_dialog.h"
#include "ui/dialogs/export_flow.h"
#include "ui/dialogs/instrument_flow.h"
#include "ui/dialogs/protocol_flow.h"
#include "ui/dialogs/safekeeping.h"
#include "ui/document/field.h"
#include "ui/entry/entry_guide.h"
#include "ui/entry/readings_finder.h"
#include "ui/forms/field_binding.h"
#include "ui/forms/field_form.h"
#include "ui/instrument/check_chart.h"
#include "ui/instrument/check_input.h"
#include "ui/instrument/instrument_dialog.h"
#include "ui/jobs/failed_job.h"
#include "ui/main_window_actions.h"
#include "ui/panels/gap/gap_panel.h"
#include "ui/panels/journal/journal_panel.h"
#include "ui/panels/model/effects_panel.h"
#include "ui/panels/model/known_sizes_panel.h"
#include "ui/panels/model/two_faces_panel.h"
#include "ui/panels/order/order_panel.h"
#include "ui/panels/parts/frames.h"
#include "ui/panels/readings/find_bar.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/readings/suspect_bar.h"
#include "ui/panels/result/findings_panel.h"
#include "ui/panels/result/result_panel.h"
#include "ui/panels/uncertainty/budget_panel.h"
#include "ui/panels/uncertainty/reliability_panel.h"
#include "ui/panels/window/changed_file_bar.h"
#include "ui/panels/window/job_status.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/self_test/installation_dialog.h"
#include "ui/series/series_window.h"
#include "ui/settings/report_settings.h"
#include "ui/settings/theme.h"
#include "ui/settings/window_font.h"
#include "ui/start/samples.h"
#include "ui/start/start_page.h"
#include "ui/text/cause_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/headline.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

/// Empty if the data contain anything except files.
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
      m_desk(new InstrumentDesk(m_document, *m_dialogs, m_job, *this)) {
  QWidget* entries = createEntryColumn();
  QWidget* results = createResultColumn();
  QSplitter* columns = split(Qt::Horizontal, "columns", {entries, results}, {518, 762});
  m_changedFile = new ChangedFileBar;
  m_stack = new QStackedWidget;
  m_stack->addWidget(stacked(m_changedFile, columns));
  setCentralWidget(m_stack);
  m_actions = new WindowActions(*this, *m_dialogs);
  m_entry = new EntryGuide(m_document, *m_positions, *this);
  m_jobs = new JobStatus(m_job, m_gapJob);
  m_next = new QLabel;
  m_next->setObjectName(QStringLiteral("next reading"));
  statusBar()->addPermanentWidget(m_desk->status());
  statusBar()->addPermanentWidget(m_next);
  statusBar()->addPermanentWidget(m_jobs);
  setAcceptDrops(true);
  m_dialogs->setReadFiles([this] { return readFiles(); });
  resize(firstSize());
  connectParts();
  restoreLayout();
  fitOnScreen();
  showTitle();
  m_job.request(m_document.session());
  m_jobs->watch();
  m_entry->goToNextEntry();
}

/// Files of the session and of the instrument check, and the logo of reports.
QStringList MainWindow::readFiles() const {
  QStringList files = m_document.paths() + m_document.readPaths();
  if (m_instrumentCheck) files += m_instrumentCheck->input().paths();
  if (const QString logo = rememberedReportChoice().logoPath; !logo.isEmpty()) files.append(logo);
  return files;
}

MainWindow::~MainWindow() {
  delete m_safekeeping;
  m_document.disconnect(this);
  m_document.undoStack().disconnect();
  m_document.halfTyped().disconnect();
  m_job.disconnect(this);
  m_gapJob.disconnect(this);
  delete takeCentralWidget();
}

QWidget* MainWindow::createEntryColumn() {
  m_forms = new QTabWidget;
  m_forms->setObjectName(QStringLiteral("forms"));
  m_forms->addTab(scrolled(createMeasurementForm(m_document)), tr("&Measurement"));
  m_forms->addTab(scrolled(createInstrumentForm(m_document)), tr("I&nstrument"));
  m_forms->addTab(scrolled(createSessionForm(m_document)), tr("Se&ssion"));
  m_forms->addTab(scrolled(createLaboratoryForm(m_document)), tr("La&boratory"));
  m_forms->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  m_forms->setAccessibleName(tr("Forms of the session"));
  m_positions = new PositionTabs(m_document);
  m_positions->setAccessibleName(tr("Positions of the axis"));
  m_findings = new FindingsPanel;
  for (int form = 0; form < m_forms->count(); ++form)
    m_forms->widget(form)->setProperty(
        "helpTopic", form == 0 || form == 1 ? QStringLiteral("first") : QStringLiteral("report"));
  m_suspects = new SuspectBar;

  auto* find = new FindBar;
  m_finder = new ReadingsFinder(m_document, *m_positions, *find);
  m_desk->setPositions(*m_positions);
  QWidget* top = stacked(m_forms, stacked(find, stacked(m_desk->questionBar(), m_positions)));
  auto* count = new QLabel;
  count->setObjectName(QStringLiteral("findings count"));
  count->setForegroundRole(QPalette::PlaceholderText);
  count->hide();
  layOutByFont(*m_findings, [this, lines = isLow() ? 1 : 3] {
    m_findings->setMinimumHeight(lines * m_findings->fontMetrics().lineSpacing());
  });
  connect(m_findings, &FindingsPanel::counted, count, [count](const QString& text) {
    count->setText(text);
    count->setVisible(!text.isEmpty());
  });
  QWidget* bottom = stacked(m_suspects, stacked(count, m_findings));
  QSplitter* column = split(Qt::Vertical, "entries", {top, bottom}, {620, isLow() ? 30 : 90});
  QWidget* entries = padded(column, {6, 6, 0, 6});
  layOutByFont(*entries, [this, entries] {
    entries->setMinimumWidth(byFont(isNarrow() ? 422 : 440));  // fits every placeholder of the forms
    entries->setMaximumWidth(byFont(760));                     // fits every column of readings, and a note
  });
  return entries;
}

QWidget* MainWindow::createResultColumn() {
  m_arcChart = new ArcChart;
  m_arcChart->setMinimumSize(isNarrow() ? 150 : 210, 150);
  m_figures = createFigures();
  m_details = createDetails();
  m_top = split(Qt::Horizontal, "arcs", {m_arcChart, m_figures}, {450, 330});
  m_top->setStretchFactor(0, 1);
  QSplitter* column = split(Qt::Vertical, "results", {m_top, m_details}, {460, 280});
  column->setStretchFactor(0, 1);
  return padded(column, {0, 6, 6, 6});
}

PageTabs* MainWindow::createFigures() {
  auto* pages = new PageTabs;
  pages->setAccessibleName(tr("Pages of the result"));
  m_effects = new EffectsPanel(m_document);
  m_result = new ResultPanel;
  pages->addPage(m_result, tr("Result"));
  m_budget = new BudgetPanel(m_document);
  pages->addPage(m_budget, tr("Budget"),
                 [this](const SharedEvaluation& evaluation) { m_budget->setEvaluation(evaluation); });
  pages->addPage(m_effects, tr("Effects"));
  return pages;
}

PageTabs* MainWindow::createDetails() {
  auto* pages = new PageTabs;
  pages->setAccessibleName(tr("Pages of the details"));
  auto* residuals = new ResidualChart;
  auto* reliability = new ReliabilityPanel;
  m_order = new OrderPanel(m_document);
  auto* faces = new TwoFacesPanel;
  residuals->setMinimumSize(240, 130);
  pages->addPage(residuals, tr("Residuals"));
  m_gap = new GapPanel;
  pages->addPage(m_gap, tr("Gap"), [](const SharedEvaluation&) {});
  pages->addPage(m_order, tr("Order"),
                 [this](const SharedEvaluation& evaluation) { m_order->setEvaluation(evaluation); });
  pages->addPage(reliability, tr("Reliability"), [reliability](const SharedEvaluation& evaluation) {
    reliability->setEvaluation(evaluation);
  });
  pages->addPage(faces, tr("Two Faces"),
                 [](const Evaluation& evaluation) { return evaluation.twoFaces.has_value(); });
  m_known = new KnownSizesPanel(m_document);
  pages->addPage(m_known, tr("Known Sizes"), [](const SharedEvaluation&) {});
  connect(m_known, &KnownSizesPanel::recordWanted, m_instrument, &InstrumentFlow::take);
  connect(m_known, &KnownSizesPanel::saveRecordWanted, m_instrument, &InstrumentFlow::save);
  m_journal = new JournalPanel;
  pages->addPage(
      m_journal, tr("Journal"),
      [this](const SharedEvaluation& evaluation) { m_journal->setEvaluation(evaluation); },
      [](const Evaluation& evaluation) {
        return !evaluation.session.journal.empty() || !evaluation.journal.empty();
      });
  connect(m_effects, &EffectsPanel::knownWanted, this, [this](const std::string& effect) {
    m_known->reveal(effect);
    m_details->showPage(m_details->indexOf(m_known));
  });
  connect(m_effects, &EffectsPanel::ownWanted, this, [this](const std::string& id) {
    commitPending();
    const std::vector<OwnEffect>& own = m_document.session().ownEffects;
    const auto found = std::ranges::find(own, id, ownId);
    typeOwnEffect(found == own.end() ? OwnEffect() : *found);
  });
  connect(m_positions, &PositionTabs::rowEntered, residuals, &ResidualChart::setHighlighted);
  connect(m_positions, &PositionTabs::rowEntered, reliability, &ReliabilityPanel::setCurrentReading);
  const auto select = [this](std::size_t position, std::size_t row) { selectReading(position, row); };
  connect(reliability, &ReliabilityPanel::sightingActivated, this, select);
  connect(faces, &TwoFacesPanel::sightingActivated, this, select);
  return pages;
}

void MainWindow::connectParts() {
  connect(&m_document, &SessionDocument::changed, this, [this](const SessionChange& change) {
    m_lastChange = change.place;
    m_suspects->setStale();
    m_budget->stopOutdatedSimulation();
    if (change.kind == SessionChange::Kind::Everything) {
      m_gapJob.setWithReference(false);
      showNoGap();
    } else {
      showGapAsOld();
    }
    m_gapJob.cancel();
    m_job.request(m_document.session());
    m_jobs->watch();
  });
  connect(m_jobs, &JobStatus::stopWanted, this, &MainWindow::stopJobs);
  connect(&m_document, &SessionDocument::identityChanged, this, &MainWindow::showTitle);
  connect(&m_document.halfTyped(), &HalfTyped::changed, this, &MainWindow::showTitle);
  connect(&m_job, &FitJob::evaluated, this, &MainWindow::showEvaluation);
  connect(&m_job, &FitJob::searched, this, &MainWindow::showSuspects);
  connect(&m_job, &FitJob::searched, m_result,
          [this](const SharedEvaluation& searched) { m_result->setSearched(*searched); });
  connect(m_budget, &BudgetPanel::checked, &m_files, &FileFlow::setBudgetCheck);
  connect(&m_files, &FileFlow::commitWanted, this, &MainWindow::commitPending);
  connect(m_findings, &FindingsPanel::placeActivated, this, [this](const Place& place) { reveal(place); });
  const auto say = [this](const QString& text) { statusBar()->showMessage(visibleLine(text), 8000); };
  connect(&m_files, &FileFlow::remark, this, say);
  connect(m_positions, &PositionTabs::remark, this, say);
  connect(m_positions, &PositionTabs::positionWanted, this, &MainWindow::addPosition);
  connect(m_positions, &PositionTabs::tableCreated, m_actions, &WindowActions::attachTo);
  for (std::size_t i = 0; m_positions->table(i); ++i) m_actions->attachTo(m_positions->table(i));
  connect(m_positions, &PositionTabs::rowEntered, m_arcChart, &ArcChart::setHighlighted);
  connectEntry();
  connectInstrument();
  connectCharts();
  connectSuspects();
  connectGap();
  connectFile();
}

void MainWindow::removePosition() {
  commitPending();
  const int position = m_positions->currentIndex();
  if (currentTable()) ui::removePosition(m_document, static_cast<std::size_t>(position));
}

void MainWindow::moveReadings() {
  commitPending();
  const ReadingsTable* table = currentTable();
  const auto count = m_document.session().positions.size();
  if (!table || count < 2) return;
  const auto from = static_cast<std::size_t>(m_positions->currentIndex()), to = (from + 1) % count;
  const std::vector<std::size_t> rows = table->selectedRows();
  const std::size_t first = m_document.session().positions[to].readings.size();
  moveRows(m_document, from, rows, to);
  if (m_document.session().positions[to].readings.size() > first) selectReading(to, first);
}

/// Forwards typed digits to the next entry, and compares readings with expected ones.
void MainWindow::connectEntry() {
  const auto show = [this](const Place& place) { reveal(place); };
  connect(m_entry, &EntryGuide::commitWanted, this, &MainWindow::commitPending);
  connect(m_entry, &EntryGuide::revealWanted, this, show);
  connect(m_entry, &EntryGuide::positionWanted, this, &MainWindow::addPosition);
  connect(m_entry, &EntryGuide::nextChanged, m_next, &QLabel::setText);
  connect(m_entry, &EntryGuide::remark, this,
          [this](const QString& text) { statusBar()->showMessage(text, 15000); });
  connect(m_finder, &ReadingsFinder::commitWanted, this, &MainWindow::commitPending);
  connect(m_finder, &ReadingsFinder::found, this, &MainWindow::reveal);
  connect(&m_document, &SessionDocument::changed, this, [this](const SessionChange& change) {
    if (change.kind != SessionChange::Kind::Everything) return;
    m_figures->setCurrentWidget(m_result);  // shows the verdict
    m_entry->goToNextEntry();
  });
}

void MainWindow::connectInstrument() {
  connect(m_desk, &InstrumentDesk::landed, this, [this](const Place& place) { reveal(place, false); });
  connect(m_desk, &InstrumentDesk::remark, this,
          [this](const QString& text) { statusBar()->showMessage(text, 15000); });
}

void MainWindow::connectFile() {
  connect(&m_watch, &FileWatch::changedElsewhere, this,
          [this](bool is) { is ? m_changedFile->tellOf(m_document.displayName()) : m_changedFile->hide(); });
  connect(&m_files, &FileFlow::writing, &m_watch, &FileWatch::setHeld);
  connect(m_changedFile, &ChangedFileBar::comparisonWanted, &m_files, &FileFlow::settleChange);
}

void MainWindow::connectCharts() {
  connect(m_exports, &ExportFlow::commitWanted, this, &MainWindow::commitPending);
  connect(m_instrument, &InstrumentFlow::commitWanted, this, &MainWindow::commitPending);
  connect(m_protocol, &ProtocolFlow::commitWanted, this, &MainWindow::commitPending);
  connect(m_order, &OrderPanel::commitWanted, this, &MainWindow::commitPending);
  connect(m_order, &OrderPanel::loadWanted, m_protocol, &ProtocolFlow::load);
  connect(m_order, &OrderPanel::saveWanted, m_protocol, &ProtocolFlow::save);
  connect(m_order, &OrderPanel::editWanted, m_protocol, &ProtocolFlow::edit);
  connect(m_order, &OrderPanel::placeActivated, this, [this](const Place& place) { reveal(place); });
  const auto show = [this](const QString& text) { statusBar()->showMessage(visibleLine(text), 8000); };
  connect(m_exports, &ExportFlow::remark, this, show);
  connect(m_instrument, &InstrumentFlow::remark, this, show);
  connect(m_protocol, &ProtocolFlow::remark, this, show);
  for (ChartFiles* files : findChildren<ChartFiles*>())
    connect(files, &ChartFiles::fileWanted, m_exports, &ExportFlow::saveChart);
  for (PlotWidget* chart : findChildren<PlotWidget*>()) {
    connect(chart, &PlotWidget::sightingActivated, this, &MainWindow::selectReading);
    connect(chart, &PlotWidget::sightingStepped, this, [this](std::size_t position, std::size_t row) {
      reveal({.position = position, .reading = row}, false);
    });
    connect(&m_document, &SessionDocument::changed, chart, [chart](const SessionChange& change) {
      if (change.kind == SessionChange::Kind::Everything) chart->showWhole();
    });
  }
}

void MainWindow::createStart() {
  m_start = new StartPage;
  m_stack->addWidget(m_start);
  connect(m_start, &StartPage::newWanted, &m_files, [this] { m_files.startNew(); });
  connect(m_start, &StartPage::openWanted, &m_files, [this] { m_files.open(); });
  connect(m_start, &StartPage::importWanted, &m_files, [this] { m_files.importReadings(); });
  connect(m_start, &StartPage::fileWanted, &m_files, [this](const QString& path) { m_files.open(path); });
  connect(m_start, &StartPage::guideWanted, m_actions, &WindowActions::showFirstSteps);
  connect(m_start, &StartPage::sampleWanted, this, [this](const QString& name) {
    const Result<Session> sample = readSample(name);
    if (sample)
      m_files.startWith(*sample);
    else
      m_dialogs->showProblem(tr("Open sample"), visibleLine(sample.problem().text()));
  });
  connect(m_start, &StartPage::sessionWanted, this, [this](const QString& typed) {
    hideStart();
    if (QWidget* entry = focusWidget(); entry && !typed.isEmpty()) {
      QKeyEvent press(QEvent::KeyPress, 0, Qt::NoModifier, typed);
      QApplication::sendEvent(entry, &press);
    }
  });
  connect(&m_document, &SessionDocument::changed, m_start, [this] { hideStart(); });
}

void MainWindow::showStart() {
  if (!m_start) createStart();
  m_start->refresh();
  m_stack->setCurrentWidget(m_start);
  m_start->focusFirst();
  m_next->hide();
}

/// Focuses the first entry, unless something has the focus already.
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
  connect(m_safekeeping, &Safekeeping::remark, this,
          [this](const QString& text) { statusBar()->showMessage(text, 8000); });
}

void MainWindow::keepNow() {
  if (m_safekeeping) m_safekeeping->keepNow();
}

bool MainWindow::offerRecovery() {
  return m_safekeeping && m_safekeeping->offer() > 0;
}

void MainWindow::connectSuspects() {
  connect(m_positions, &PositionTabs::rowEntered, m_suspects, &SuspectBar::showReading);
  connect(m_suspects, &SuspectBar::placeActivated, this, [this](const Place& place) { reveal(place); });
  connect(m_suspects, &SuspectBar::changesWanted, this,
          [this](const std::vector<CellChange>& changes, const QString& undoText) {
            commitPending();
            applyChanges(m_document, changes, undoText);
            reveal(changes.front().where);
          });
  connect(m_suspects, &SuspectBar::exclusionWanted, this, &MainWindow::excludeRow);
}

void MainWindow::connectGap() {
  connect(&m_job, &FitJob::evaluated, &m_gapJob, &GapJob::request);
  connect(&m_gapJob, &GapJob::assessed, this, &MainWindow::showGap);
  connect(m_gap, &GapPanel::watched, &m_gapJob, &GapJob::setWatched);
  connect(m_gap, &GapPanel::placeActivated, this, [this](const Place& place) { reveal(place); });
  connect(m_gap, &GapPanel::exclusionWanted, this, &MainWindow::excludeRow);
  connect(m_gap, &GapPanel::rowsExclusionWanted, this, [this](const RowRange& range) {
    commitPending();
    std::vector<std::size_t> rows(range.count);
    std::iota(rows.begin(), rows.end(), range.first);
    ReadingsEditor(m_document, range.position).setExcluded(rows, true);
    m_gap->setFocus();
  });
  connect(m_gap, &GapPanel::noiseWanted, this, [this](const StatedNoise& noise) {
    commitPending();
    stateNoise(m_document, noise);
    m_gap->setFocus();
  });
  connect(m_gap, &GapPanel::effectsWanted, this, [this](const QStringList& ids) {
    commitPending();
    std::vector<std::string> effects;
    for (const QString& id : ids) effects.push_back(id.toStdString());
    addEffects(m_document, effects);
    m_gap->setFocus();
  });
  connect(m_gap, &GapPanel::formWanted, this, [this](const FoundForm& form) {
    commitPending();
    typeOwnEffect(ownEffectOf(form, m_document.session()));
  });
  connect(m_gap, &GapPanel::effectUnwanted, this, [this](const QString& id) {
    commitPending();
    setEffect(m_document, id.toStdString(), false);
    m_gap->setFocus();
  });
  connect(m_gap, &GapPanel::relationWanted, this, [this](const QString& text) {
    commitPending();
    changeField(m_document, {.field = "model.vertical_angle"}, text.toStdString());
    m_gap->setFocus();
  });
  connect(m_gap, &GapPanel::referenceWanted, this, [this](bool wanted) {
    commitPending();
    m_gapJob.setWithReference(wanted);
    showGapAsOld();
    m_gap->setFocus();
    if (m_job.isFitting()) return;  // the result of the fit will be diagnosed
    m_gapJob.request(m_shown);
    m_jobs->watch();
  });
  const auto lead = [this] { m_details->showPage(m_details->indexOf(m_gap)); };
  connect(m_result, &ResultPanel::gapActivated, this, lead);
  connect(m_findings, &FindingsPanel::gapActivated, this, lead);
}

void MainWindow::excludeRow(const Place& place) {
  commitPending();
  ReadingsEditor(m_document, *place.position).setExcluded({*place.reading}, true);
  reveal(place);
}

void MainWindow::selectReading(std::size_t position, std::size_t row) {
  reveal({.position = position, .reading = row, .field = "horizontal"});
}

ReadingsTable* MainWindow::currentTable() const {
  return m_positions->currentTable();
}

void MainWindow::setColumnShown(ReadingColumn column, bool shown) {
  m_positions->setColumnShown(column, shown);
}

void MainWindow::setDetailsEnlarged(bool enlarged) {
  m_top->setVisible(!enlarged);
}

void MainWindow::showBlindTrials() {
  if (!m_blindTrials) {
    m_blindTrials = new BlindTrialDialog(this);
    connect(m_blindTrials, &BlindTrialDialog::sessionWanted, this, [this](const Session& session) {
      if (m_files.startWith(session)) m_details->showPage(m_details->indexOf(m_gap));
    });
  }
  m_blindTrials->show();
  m_blindTrials->raise();
  m_blindTrials->activateWindow();
}

void MainWindow::showInstrumentCheck() {
  if (!m_instrumentCheck) {
    m_instrumentCheck = new InstrumentDialog(*m_dialogs, this);
    connect(&m_instrumentCheck->chart().files(), &ChartFiles::fileWanted, m_exports, &ExportFlow::saveChart);
  }
  m_instrumentCheck->show();
  m_instrumentCheck->raise();
  m_instrumentCheck->activateWindow();
}

void MainWindow::showInstallationCheck() {
  if (!m_installationCheck) m_installationCheck = new InstallationDialog(*m_dialogs, this);
  m_installationCheck->show();
  m_installationCheck->raise();
  m_installationCheck->activateWindow();
}

void MainWindow::showSeries() {
  if (!m_series) {
    m_series = new SeriesWindow(*m_dialogs, this);
    connect(m_series, &SeriesWindow::sessionWanted, this, [this](const QString& path) {
      if (m_files.open(path)) activateWindow();
    });
  }
  m_series->show();
  m_series->raise();
  m_series->activateWindow();
}

void MainWindow::tellFailure(const QString& reason) {
  const std::string told = ui::tellFailure({.job = QT_TRANSLATE_NOOP("Job", "window"),
                                            .reason = reason.toStdString(),
                                            .session = m_document.session()});
  m_dialogs->showProblem(tr("Something went wrong"), qText(told));
}

void MainWindow::showTitle() {
  const QString mark = QStringLiteral("[*]");
  QString name = visibleLine(m_document.displayName());
  name.replace(mark, mark + mark);  // escapes the name's own marks of a changed file
  // Ends in the program's name, which Qt would add otherwise.
  setWindowTitle(QStringLiteral("%1[*] — %2 — Alidade").arg(name, qText(versionAndBuild())));
  setWindowModified(m_document.isModified() || !m_document.halfTyped().isEmpty());
}

void MainWindow::showEvaluation(const SharedEvaluation& evaluation) {
  m_shown = evaluation;
  m_entry->setEvaluation(evaluation);
  showSuspects(evaluation);
  m_arcChart->setEvaluation(*evaluation);
  m_figures->setEvaluation(evaluation);
  m_details->setEvaluation(evaluation);
  showHeadline(headlineOf(*evaluation));
  markForms();
}

void MainWindow::showHeadline(const Headline& headline) {
  m_result->setHeadline(headline);
  m_arcChart->plot()->setHeadline(headline);
  m_entry->setHeadline(headline);
}

/// Updates only the parts after the fit, since the figures have not changed.
void MainWindow::showSuspects(const SharedEvaluation& evaluation) {
  m_positions->setEvaluation(evaluation);
  m_suspects->setEvaluation(*evaluation);
  m_findings->setEvaluation(*evaluation);
  m_journal->setSummary(*evaluation);
  m_order->setSearched(evaluation);
}

void MainWindow::showGap(const SharedGap& gap) {
  const QString headline = gap->isOpen() ? gapHeadline(*gap->diagnosis) : QString();
  showHeadline(headlineOf(*gap));
  m_gap->setGap(gap);
  m_result->setGap(*gap);
  m_budget->setGap(*gap);
  m_findings->setGap(headline);
  m_order->setGap(gap);
  m_details->setTabIcon(m_details->indexOf(m_gap),
                        gap->isOpen() ? themeIcon(QStringLiteral("warning")) : QIcon());
  m_isGapOld = false;
}

/// Marks the gap as old until the diagnosis of the current session is done.
void MainWindow::typeOwnEffect(const OwnEffect& effect) {
  if (const std::optional<OwnEffect> typed = m_dialogs->askOwnEffect(m_document.session(), effect))
    keepOwnEffect(m_document, *typed);
}

void MainWindow::showGapAsOld() {
  if (std::exchange(m_isGapOld, true)) return;
  m_gap->setStale();
  m_result->setGapStale();
  if (m_shown) showHeadline(headlineOf(*m_shown));
  m_budget->setGapStale();
  m_findings->setGapStale();
  const int page = m_details->indexOf(m_gap);
  const QIcon icon = m_details->tabIcon(page);
  if (!icon.isNull()) m_details->setTabIcon(page, icon.pixmap(m_details->iconSize(), QIcon::Disabled));
}

/// Another session, not diagnosed yet.
void MainWindow::showNoGap() {
  m_gap->clear();
  m_result->clearGap();
  if (m_shown) showHeadline(headlineOf(*m_shown));
  m_budget->clearGap();
  m_findings->clearGap();
  m_details->setTabIcon(m_details->indexOf(m_gap), QIcon());
  m_isGapOld = false;
}

/// Stops the jobs after the fit, and marks their results as unknown.
void MainWindow::stopJobs() {
  if (m_job.isFitting() || !m_shown) return;
  if (m_job.isSearching()) {
    m_job.stopSearch();
    m_suspects->setUnknown();
    statusBar()->showMessage(tr("Stopped: misread readings were not looked for."), 8000);
  }
  if (m_gapJob.isIdle()) return;
  m_gapJob.cancel();
  showGap(std::make_shared<const Gap>(
      noGap(m_shown, tr("The diagnosis was stopped. The next edit takes it up again.").toStdString())));
}

void MainWindow::markForms() {
  for (int tab = 0; tab < m_forms->count(); ++tab) {
    const auto bindings = m_forms->widget(tab)->findChildren<FieldBinding*>();
    const bool wrong = std::any_of(bindings.begin(), bindings.end(),
                                   [](const FieldBinding* binding) { return !binding->problem().isEmpty(); });
    markTab(*m_forms, tab, wrong);
  }
  markTab(*m_details, m_details->indexOf(m_known), m_known->hasProblem());
}

void MainWindow::reveal(const Place& place, bool takeFocus) {
  if (!place.position || !place.reading) {
    revealField(place, takeFocus);
    return;
  }
  const ReadingsTable* table = m_positions->table(*place.position);
  if (!table) return;
  hideStart();
  const bool keepColumn = place.field.empty() && table->currentIndex().isValid();
  m_positions->selectCell(
      *place.position, *place.reading,
      keepColumn ? static_cast<ReadingColumn>(table->currentIndex().column()) : readingColumn(place.field));
  if (takeFocus) currentTable()->setFocus();
}

void MainWindow::revealField(const Place& place, bool takeFocus) {
  if (place.field == "model.effects" || place.field.starts_with("own_effects"))
    return m_figures->setCurrentWidget(m_effects);
  if (const auto known = knownAt(place)) {
    m_known->reveal(*known);
    m_details->setCurrentWidget(m_known);
    if (takeFocus) m_known->setFocus();
    return;
  }
  for (const FieldBinding* binding : findChildren<FieldBinding*>()) {
    if (binding->place() != place) continue;
    m_positions->uncover(place);
    for (QWidget* page = binding->widget(); page; page = page->parentWidget()) {
      for (QTabWidget* tabs : {m_forms, static_cast<QTabWidget*>(m_positions)}) {
        if (tabs->indexOf(page) >= 0) tabs->setCurrentWidget(page);
      }
    }
    if (takeFocus) binding->widget()->setFocus(Qt::TabFocusReason);
    return;
  }
  if (place.position) m_positions->showPosition(*place.position);
}

void MainWindow::commitPending() {
  if (ReadingsTable* table = currentTable()) table->commitOpenEditor();
  m_known->commitOpenEditor();
  for (FieldBinding* binding : findChildren<FieldBinding*>()) emit binding->commitWanted();
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
  setDetailsEnlarged(false);
  saveLayout();
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

/// A screen of 1920 pixels at scale 2 has 960.
bool MainWindow::isNarrow() const {
  return screen()->availableGeometry().width() < 1000;
}

bool MainWindow::isLow() const {
  return screen()->availableGeometry().height() < 620;
}

/// Most of a large screen, within a comfortable field of view.
QSize MainWindow::firstSize() const {
  constexpr QSize usual(1280, 800), largest(1800, 1100);
  return (screen()->availableGeometry().size() * 0.75).expandedTo(usual).boundedTo(largest);
}

/// Includes the frame; the remembered size may be from a larger screen.
void MainWindow::fitOnScreen() {
  constexpr QSize frame(16, 40);
  const QRect room = screen()->availableGeometry();
  resize(size().boundedTo(room.size() - frame));
}

void MainWindow::restoreLayout() {
  const QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
  restoreState(settings.value(QStringLiteral("window/state")).toByteArray());
  for (QSplitter* splitter : findChildren<QSplitter*>()) {
    splitter->restoreState(settings.value(QStringLiteral("window/") + splitter->objectName()).toByteArray());
  }
}

void MainWindow::saveLayout() const {
  QSettings settings;
  settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
  settings.setValue(QStringLiteral("window/state"), saveState());
  for (const QSplitter* splitter : findChildren<QSplitter*>()) {
    settings.setValue(QStringLiteral("window/") + splitter->objectName(), splitter->saveState());
  }
}

}  // namespace alidade::ui
