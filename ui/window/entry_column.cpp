#include "ui/window/entry_column.h"

#include <QLabel>
#include <QSplitter>
#include <QTabWidget>
#include <QTimer>
#include <algorithm>

#include "ui/commands/change_positions.h"
#include "ui/commands/edit_readings.h"
#include "ui/connection/instrument_desk.h"
#include "ui/connection/reading_question_bar.h"
#include "ui/document/session_document.h"
#include "ui/entry/readings_finder.h"
#include "ui/forms/field_binding.h"
#include "ui/forms/field_form.h"
#include "ui/panels/journal/change_reason_bar.h"
#include "ui/panels/parts/frames.h"
#include "ui/panels/readings/find_bar.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/readings/suspect_bar.h"
#include "ui/panels/result/findings_panel.h"
#include "ui/settings/theme.h"
#include "ui/settings/window_font.h"
#include "ui/text/cause_text.h"
#include "ui/window/session_jobs.h"
#include "ui/window/window_layout.h"

namespace alidade::ui {

namespace {

QString windowText(const char* text) {
  return QCoreApplication::translate("alidade::ui::MainWindow", text);
}

}  // namespace

EntryColumn::EntryColumn(SessionDocument& document, SessionJobs& jobs, InstrumentDesk& desk,
                         const QWidget& window)
    : m_document(document),
      m_forms(new QTabWidget),
      m_positions(new PositionTabs(document)),
      m_findings(new FindingsPanel),
      m_suspects(new SuspectBar),
      m_changeReason(new ChangeReasonBar(document)) {
  createForms();
  m_positions->setAccessibleName(
      windowText(QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Positions of the axis")));
  auto* find = new FindBar;
  m_finder = new ReadingsFinder(document, *m_positions, *find);
  desk.setPositions(*m_positions);
  QWidget* top = stacked(m_forms, stacked(find, stacked(desk.questionBar(), m_positions)));
  const bool low = isLow(window);
  m_column = split(Qt::Vertical, "entries", {top, createFindings(low)}, {620, low ? 30 : 90});
  m_widget = padded(m_column, {6, 6, 0, 6});
  layOutByFont(*m_widget, [widget = m_widget, &window] {
    const int least = isNarrow(window) ? 422 : 440;  // fits every placeholder of the forms
    widget->setMinimumWidth(withinScreen(window, byFont(least), least, 45));
    widget->setMaximumWidth(byFont(760));  // fits every column of readings, and a note
  });
  setParent(m_widget);
  connect(m_finder, &ReadingsFinder::commitWanted, this, &EntryColumn::commitWanted);
  connect(m_finder, &ReadingsFinder::found, this, &EntryColumn::revealWanted);
  connect(&jobs, &SessionJobs::suspectsChanged, m_positions, &PositionTabs::setEvaluation);
  connect(&jobs, &SessionJobs::evaluated, this, &EntryColumn::markForms);
  connectSuspects(jobs);
  connectFindings(jobs);
}

void EntryColumn::createForms() {
  m_forms->setObjectName(QStringLiteral("forms"));
  const struct {
    QWidget* form;
    const char* title;
    const char* helpTopic;
  } forms[] = {
      {createMeasurementForm(m_document), QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "&Measurement"),
       "first"},
      {createInstrumentForm(m_document), QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "I&nstrument"),
       "first"},
      {createSessionForm(m_document), QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Se&ssion"), "report"},
      {createLaboratoryForm(m_document), QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "La&boratory"),
       "report"}};
  for (const auto& [form, title, helpTopic] : forms) {
    QWidget* page = scrolled(form);
    page->setProperty("helpTopic", QString::fromLatin1(helpTopic));
    m_forms->addTab(page, windowText(title));
  }
  m_forms->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  m_forms->setAccessibleName(
      windowText(QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Forms of the session")));
}

QWidget* EntryColumn::createFindings(bool isLow) {
  auto* count = new QLabel;
  count->setObjectName(QStringLiteral("findings count"));
  count->setForegroundRole(QPalette::PlaceholderText);
  count->hide();
  layOutByFont(*m_findings, [findings = m_findings, lines = isLow ? 1 : 3] {
    findings->setMinimumHeight(lines * findings->fontMetrics().lineSpacing());
  });
  connect(m_findings, &FindingsPanel::counted, count, [count](const QString& text) {
    count->setText(text);
    count->setVisible(!text.isEmpty());
  });
  return stacked(m_changeReason, stacked(m_suspects, stacked(count, m_findings)));
}

void EntryColumn::connectSuspects(SessionJobs& jobs) {
  connect(&m_document, &SessionDocument::changed, m_suspects, &SuspectBar::setStale);
  connect(&jobs, &SessionJobs::searchStopped, m_suspects, &SuspectBar::setUnknown);
  connect(&jobs, &SessionJobs::suspectsChanged, m_suspects,
          [this](const SharedEvaluation& evaluation) { m_suspects->setEvaluation(*evaluation); });
  connect(m_positions, &PositionTabs::rowEntered, m_suspects, &SuspectBar::showReading);
  connect(m_suspects, &SuspectBar::placeActivated, this,
          [this](const Place& place) { emit revealWanted(place, true); });
  connect(m_suspects, &SuspectBar::changesWanted, this,
          [this](const std::vector<CellChange>& changes, const QString& undoText) {
            emit commitWanted();
            applyChanges(m_document, changes, undoText);
            emit revealWanted(changes.front().where, true);
          });
  connect(m_suspects, &SuspectBar::exclusionWanted, this, [this](const Place& place) {
    emit commitWanted();
    ReadingsEditor(m_document, *place.position).setExcluded({*place.reading}, true);
    emit revealWanted(place, true);
    m_positions->table(*place.position)->askReason({*place.reading});
  });
}

void EntryColumn::connectFindings(SessionJobs& jobs) {
  connect(&jobs, &SessionJobs::suspectsChanged, m_findings,
          [this](const SharedEvaluation& evaluation) { m_findings->setEvaluation(*evaluation); });
  connect(&jobs, &SessionJobs::gapChanged, m_findings, [this](const SharedGap& gap) {
    m_findings->setGap(gap->isOpen() ? gapHeadline(*gap->diagnosis) : QString());
  });
  connect(&jobs, &SessionJobs::gapAged, m_findings, &FindingsPanel::setGapStale);
  connect(&jobs, &SessionJobs::gapCleared, m_findings, &FindingsPanel::clearGap);
  // Waits for the posted events that lay out the lines above the list.
  connect(m_findings, &FindingsPanel::listed, this,
          [this] { QTimer::singleShot(0, this, &EntryColumn::giveFindingsRoom); });
  connect(m_findings, &FindingsPanel::gapActivated, this, &EntryColumn::gapWanted);
  connect(m_findings, &FindingsPanel::placeActivated, this,
          [this](const Place& place) { emit revealWanted(place, true); });
}

/// Gives the findings the height of all their lines, up to a third of the column; some rows of readings stay
/// visible. Keeps a height set by the user. Reduces the height only if the lines need less than half of it,
/// since lines on a half-typed row appear and disappear with each reading.
void EntryColumn::giveFindingsRoom() {
  if (isSetByHand(*m_column)) return;
  QList<int> sizes = m_column->sizes();
  const int whole = sizes[0] + sizes[1], beside = sizes[1] - m_findings->height();
  const int needed = std::max(m_findings->wholeHeight(), m_findings->minimumHeight()) + beside;
  const bool isLeftOver = 2 * needed < sizes[1];
  if (needed <= sizes[1] && !isLeftOver) return;
  const auto give = [&](int height) {
    sizes = {whole - height, height};
    m_column->setSizes(sizes);
  };
  const int most = std::max(whole / 3, m_column->widget(1)->minimumSizeHint().height());
  give(std::min(needed, most));
  // The widgets above the list may have grown.
  if (const int cut = m_findings->wholeHeight() - m_findings->height(); cut > 0)
    give(std::min(sizes[1] + cut, most));
  ReadingsTable* table = m_positions->currentTable();
  if (!table) return;
  // The forms may take a part of the height that the first pass returns, so that a second pass is needed.
  constexpr int leastRows = 5;
  const int least = m_column->widget(1)->minimumSizeHint().height();
  for (int pass = 0; pass < 2; ++pass) {
    const int lacking = leastRows * table->rowHeight(0) - table->viewport()->height();
    if (lacking <= 0 || sizes[1] <= least) break;
    give(std::max(least, sizes[1] - lacking));
  }
  if (table->currentIndex().isValid()) table->scrollTo(table->currentIndex());
}

void EntryColumn::markForms() {
  for (int tab = 0; tab < m_forms->count(); ++tab) {
    const auto bindings = m_forms->widget(tab)->findChildren<FieldBinding*>();
    const bool wrong = std::any_of(bindings.begin(), bindings.end(),
                                   [](const FieldBinding* binding) { return !binding->problem().isEmpty(); });
    markTab(*m_forms, tab, wrong);
  }
}

void EntryColumn::commit() {
  if (ReadingsTable* table = m_positions->currentTable()) {
    table->commitOpenEditor();
    table->commitReason();
  }
  for (FieldBinding* binding : m_widget->findChildren<FieldBinding*>()) emit binding->commitWanted();
  m_changeReason->finish();
}

void EntryColumn::reveal(const Place& place, bool takeFocus) {
  if (place.position && place.reading) return revealReading(place, takeFocus);
  for (const FieldBinding* binding : m_widget->findChildren<FieldBinding*>()) {
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

void EntryColumn::revealReading(const Place& place, bool takeFocus) {
  const ReadingsTable* table = m_positions->table(*place.position);
  if (!table) return;
  const bool keepColumn = place.field.empty() && table->currentIndex().isValid();
  m_positions->selectCell(
      *place.position, *place.reading,
      keepColumn ? static_cast<ReadingColumn>(table->currentIndex().column()) : readingColumn(place.field));
  if (takeFocus) m_positions->currentTable()->setFocus();
}

void EntryColumn::moveReadings() {
  emit commitWanted();
  const ReadingsTable* table = m_positions->currentTable();
  const auto count = m_document.session().positions.size();
  if (!table || count < 2) return;
  const auto from = static_cast<std::size_t>(m_positions->currentIndex()), to = (from + 1) % count;
  const std::vector<std::size_t> rows = table->selectedRows();
  const std::size_t first = m_document.session().positions[to].readings.size();
  moveRows(m_document, from, rows, to);
  if (m_document.session().positions[to].readings.size() > first)
    emit revealWanted({.position = to, .reading = first, .field = "horizontal"}, true);
}

}  // namespace alidade::ui
