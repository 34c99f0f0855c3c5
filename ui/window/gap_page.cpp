#include <numeric>

#include "core/diagnosis/kept_form.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/document/session_document.h"
#include "ui/panels/gap/gap_panel.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/settings/theme.h"
#include "ui/window/pages.h"
#include "ui/window/result_column.h"
#include "ui/window/session_jobs.h"

namespace alidade::ui {

namespace {

void showGapsIn(GapPanel* panel, SessionJobs& jobs, ResultColumn& column) {
  const auto setIcon = [&column](const QIcon& icon) {
    const auto [tabs, index] = column.tab("gap");
    tabs->setTabIcon(index, icon);
  };
  QObject::connect(panel, &GapPanel::watched, &jobs.gap(), &GapJob::setWatched);
  QObject::connect(&jobs, &SessionJobs::gapChanged, panel, [panel, setIcon](const SharedGap& gap) {
    panel->setGap(gap);
    setIcon(gap->isOpen() ? themeIcon(QStringLiteral("warning")) : QIcon());
  });
  QObject::connect(&jobs, &SessionJobs::gapAged, panel, [panel, &column] {
    panel->setStale();
    const auto [tabs, index] = column.tab("gap");
    const QIcon icon = tabs->tabIcon(index);
    if (!icon.isNull()) tabs->setTabIcon(index, icon.pixmap(tabs->iconSize(), QIcon::Disabled));
  });
  QObject::connect(&jobs, &SessionJobs::gapCleared, panel, [panel, setIcon] {
    panel->clear();
    setIcon({});
  });
}

/// Lets a signal of the panel edit the session; the keyboard stays on the page.
template <typename Value, typename Edit>
void letEdit(GapPanel* panel, void (GapPanel::*wanted)(Value), ResultColumn& column, Edit edit) {
  QObject::connect(panel, wanted, panel, [panel, &column, edit](Value value) {
    emit column.commitWanted();
    edit(value);
    panel->setFocus();
  });
}

void letEditModel(GapPanel* panel, SessionDocument& document, ResultColumn& column) {
  letEdit(panel, &GapPanel::noiseWanted, column,
          [&document](const StatedNoise& noise) { stateNoise(document, noise); });
  letEdit(panel, &GapPanel::effectsWanted, column, [&document](const QStringList& ids) {
    std::vector<std::string> effects;
    for (const QString& id : ids) effects.push_back(id.toStdString());
    addEffects(document, effects);
  });
  letEdit(panel, &GapPanel::effectUnwanted, column,
          [&document](const QString& id) { setEffect(document, id.toStdString(), false); });
  letEdit(panel, &GapPanel::relationWanted, column, [&document](const QString& text) {
    changeField(document, {.field = "model.vertical_angle"}, text.toStdString());
  });
}

void letExclude(GapPanel* panel, const WindowParts& parts, ResultColumn& column) {
  QObject::connect(panel, &GapPanel::exclusionWanted, panel, [parts, &column](const Place& place) {
    emit column.commitWanted();
    ReadingsEditor(parts.document, *place.position).setExcluded({*place.reading}, true);
    emit column.revealWanted(place, true);
    parts.positions.table(*place.position)->askReason({*place.reading});
  });
  letEdit(panel, &GapPanel::rowsExclusionWanted, column, [&document = parts.document](const RowRange& range) {
    std::vector<std::size_t> rows(range.count);
    std::iota(rows.begin(), rows.end(), range.first);
    ReadingsEditor(document, range.position).setExcluded(rows, true);
  });
}

}  // namespace

MadePage makeGapPage(const WindowParts& parts, ResultColumn& column) {
  auto* panel = new GapPanel;
  showGapsIn(panel, parts.jobs, column);
  letEditModel(panel, parts.document, column);
  letExclude(panel, parts, column);
  letEdit(panel, &GapPanel::referenceWanted, column,
          [&jobs = parts.jobs](bool wanted) { jobs.setWithReference(wanted); });
  QObject::connect(panel, &GapPanel::placeActivated, &column,
                   [&column](const Place& place) { emit column.revealWanted(place, true); });
  QObject::connect(panel, &GapPanel::formWanted, panel, [parts, &column](const FoundForm& form) {
    emit column.commitWanted();
    typeOwnEffect(parts, ownEffectOf(form, parts.document.session()));
  });
  return {panel, [](const SharedEvaluation&) {}};
}

}  // namespace alidade::ui
