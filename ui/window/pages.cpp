#include "ui/window/pages.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/session/own_effects.h"
#include "ui/charts/residuals/residual_chart.h"
#include "ui/charts/residuals/residual_page.h"
#include "ui/commands/change_session.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/file_flow.h"
#include "ui/dialogs/instrument_flow.h"
#include "ui/dialogs/protocol_flow.h"
#include "ui/document/session_document.h"
#include "ui/panels/journal/journal_panel.h"
#include "ui/panels/model/effects_panel.h"
#include "ui/panels/model/known_sizes_panel.h"
#include "ui/panels/model/two_faces_panel.h"
#include "ui/panels/order/order_panel.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/result/result_panel.h"
#include "ui/panels/uncertainty/budget_panel.h"
#include "ui/panels/uncertainty/reliability_panel.h"
#include "ui/settings/theme.h"
#include "ui/window/result_column.h"
#include "ui/window/session_jobs.h"

namespace alidade::ui {

namespace {

MadePage makeResult(const WindowParts& parts, ResultColumn& column) {
  auto* panel = new ResultPanel;
  QObject::connect(&parts.jobs.fit(), &FitJob::searched, panel,
                   [panel](const SharedEvaluation& searched) { panel->setSearched(*searched); });
  QObject::connect(&parts.jobs, &SessionJobs::headlineChanged, panel, &ResultPanel::setHeadline);
  QObject::connect(&parts.jobs, &SessionJobs::gapAged, panel, &ResultPanel::setGapStale);
  QObject::connect(&parts.jobs, &SessionJobs::gapCleared, panel, &ResultPanel::clearGap);
  QObject::connect(panel, &ResultPanel::gapActivated, &column, [&column] { column.showPage("gap"); });
  return {panel, showIn(panel)};
}

MadePage makeBudget(const WindowParts& parts, ResultColumn&) {
  auto* panel = new BudgetPanel(parts.document);
  QObject::connect(&parts.document, &SessionDocument::changed, panel, &BudgetPanel::stopOutdatedSimulation);
  QObject::connect(&parts.jobs, &SessionJobs::gapChanged, panel,
                   [panel](const SharedGap& gap) { panel->setGap(*gap); });
  QObject::connect(&parts.jobs, &SessionJobs::gapAged, panel, &BudgetPanel::setGapStale);
  QObject::connect(&parts.jobs, &SessionJobs::gapCleared, panel, &BudgetPanel::clearGap);
  QObject::connect(panel, &BudgetPanel::checked, &parts.files, &FileFlow::setBudgetCheck);
  return {panel, showIn(panel)};
}

MadePage makeEffects(const WindowParts& parts, ResultColumn& column) {
  auto* panel = new EffectsPanel(parts.document);
  QObject::connect(panel, &EffectsPanel::knownWanted, &column, [&column](const std::string& effect) {
    column.panel<KnownSizesPanel>()->reveal(effect);
    column.showPage("known-sizes");
  });
  QObject::connect(panel, &EffectsPanel::ownWanted, &column, [parts, &column](const std::string& id) {
    emit column.commitWanted();
    const std::vector<OwnEffect>& own = parts.document.session().ownEffects;
    const auto found = std::ranges::find(own, id, ownId);
    typeOwnEffect(parts, found == own.end() ? OwnEffect() : *found);
  });
  return {panel, showIn(panel)};
}

MadePage makeResiduals(const WindowParts& parts, ResultColumn&) {
  auto* page = new ResidualPage;
  QObject::connect(&parts.positions, &PositionTabs::rowEntered, page->chart(),
                   &ResidualChart::setHighlighted);
  return {page, showIn(page->chart())};
}

MadePage makeOrder(const WindowParts& parts, ResultColumn& column) {
  auto* panel = new OrderPanel(parts.document);
  QObject::connect(&parts.jobs, &SessionJobs::suspectsChanged, panel, &OrderPanel::setSearched);
  QObject::connect(&parts.jobs, &SessionJobs::gapChanged, panel, &OrderPanel::setGap);
  QObject::connect(panel, &OrderPanel::commitWanted, &column, &ResultColumn::commitWanted);
  QObject::connect(panel, &OrderPanel::loadWanted, &parts.protocol, &ProtocolFlow::load);
  QObject::connect(panel, &OrderPanel::saveWanted, &parts.protocol, &ProtocolFlow::save);
  QObject::connect(panel, &OrderPanel::editWanted, &parts.protocol, &ProtocolFlow::edit);
  QObject::connect(panel, &OrderPanel::placeActivated, &column,
                   [&column](const Place& place) { emit column.revealWanted(place, true); });
  return {panel, showIn(panel)};
}

MadePage makeReliability(const WindowParts& parts, ResultColumn& column) {
  auto* panel = new ReliabilityPanel;
  QObject::connect(&parts.positions, &PositionTabs::rowEntered, panel, &ReliabilityPanel::setCurrentReading);
  QObject::connect(panel, &ReliabilityPanel::sightingActivated, &column, &ResultColumn::select);
  return {panel, showIn(panel)};
}

MadePage makeTwoFaces(const WindowParts&, ResultColumn& column) {
  auto* panel = new TwoFacesPanel;
  QObject::connect(panel, &TwoFacesPanel::sightingActivated, &column, &ResultColumn::select);
  return {panel, showIn(panel), [](const Evaluation& evaluation) { return evaluation.twoFaces.has_value(); }};
}

MadePage makeKnownSizes(const WindowParts& parts, ResultColumn& column) {
  auto* panel = new KnownSizesPanel(parts.document);
  QObject::connect(panel, &KnownSizesPanel::recordWanted, &parts.instrument, &InstrumentFlow::take);
  QObject::connect(panel, &KnownSizesPanel::saveRecordWanted, &parts.instrument, &InstrumentFlow::save);
  QObject::connect(&parts.jobs, &SessionJobs::evaluated, panel, [panel, &column] {
    const auto [tabs, index] = column.tab("known-sizes");
    markTab(*tabs, index, panel->hasProblem());
  });
  return {panel, [](const SharedEvaluation&) {}};
}

MadePage makeJournal(const WindowParts& parts, ResultColumn&) {
  auto* panel = new JournalPanel;
  QObject::connect(&parts.jobs, &SessionJobs::suspectsChanged, panel,
                   [panel](const SharedEvaluation& evaluation) { panel->setSummary(*evaluation); });
  return {panel, showIn(panel), [](const Evaluation& evaluation) {
            return !evaluation.session.journal.empty() || !evaluation.journal.empty();
          }};
}

constexpr PageInfo pages[] = {
    {"result", QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Result"), "result", "Ctrl+1", PageSide::Beside,
     makeResult},
    {"budget", QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Budget"), "uncertainty", "Ctrl+2",
     PageSide::Beside, makeBudget},
    {"effects", QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Effects"), "known-sizes#effects", "Ctrl+3",
     PageSide::Beside, makeEffects},
    {"residuals", QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Residuals"), "result#residuals", "Ctrl+4",
     PageSide::Below, makeResiduals},
    {"gap", QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Gap"), "gap", "Ctrl+5", PageSide::Below,
     makeGapPage},
    {"order", QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Order"), "entering#order", "Ctrl+6",
     PageSide::Below, makeOrder},
    {"reliability", QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Reliability"), "uncertainty#reliability",
     "Ctrl+7", PageSide::Below, makeReliability},
    {"two-faces", QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Two Faces"), "uncertainty#faces", "Ctrl+8",
     PageSide::Below, makeTwoFaces},
    {"known-sizes", QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Known Sizes"), "known-sizes", "Ctrl+9",
     PageSide::Below, makeKnownSizes},
    {"journal", QT_TRANSLATE_NOOP("alidade::ui::MainWindow", "Journal"), "report#journal", "Ctrl+J",
     PageSide::Below, makeJournal},
};

}  // namespace

std::span<const PageInfo> allPages() {
  return pages;
}

void typeOwnEffect(const WindowParts& parts, const OwnEffect& effect) {
  if (const std::optional<OwnEffect> typed = parts.dialogs.askOwnEffect(parts.document.session(), effect))
    keepOwnEffect(parts.document, *typed);
}

}  // namespace alidade::ui
