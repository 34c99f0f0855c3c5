#include "ui/window/result_column.h"

#include <QCoreApplication>
#include <QSplitter>

#include "ui/charts/arc/arc_chart.h"
#include "ui/charts/arc/arc_plot.h"
#include "ui/charts/plotting/chart_files.h"
#include "ui/charts/plotting/plot_widget.h"
#include "ui/dialogs/export_flow.h"
#include "ui/document/known_entry.h"
#include "ui/document/session_document.h"
#include "ui/panels/model/known_sizes_panel.h"
#include "ui/panels/parts/frames.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/window/session_jobs.h"
#include "ui/window/window_layout.h"

namespace alidade::ui {

ResultColumn::ResultColumn(const WindowParts& parts, const QWidget& window)
    : m_picture(new ArcChart), m_beside(new PageTabs), m_below(new PageTabs) {
  m_picture->setMinimumSize(isNarrow(window) ? 150 : 210, 150);
  m_beside->setAccessibleName(QCoreApplication::translate("alidade::ui::MainWindow", "Pages of the result"));
  m_below->setAccessibleName(QCoreApplication::translate("alidade::ui::MainWindow", "Pages of the details"));
  for (const PageInfo& info : allPages()) {
    MadePage page = info.make(parts, *this);
    page.widget->setProperty("helpTopic", QString::fromLatin1(info.helpTopic));
    (info.side == PageSide::Beside ? m_beside : m_below)
        ->addPage(page.widget, QCoreApplication::translate("alidade::ui::MainWindow", info.title),
                  std::move(page.show), std::move(page.wanted));
  }
  QSplitter* top = split(Qt::Horizontal, "arcs", {m_picture, m_beside}, {450, 330});
  top->setStretchFactor(0, 1);
  m_top = top;
  QSplitter* column = split(Qt::Vertical, "results", {m_top, m_below}, {460, 280});
  column->setStretchFactor(0, 1);
  m_widget = padded(column, {0, 6, 6, 6});
  setParent(m_widget);
  connectPicture(parts);
  for (PageTabs* tabs : {m_beside, m_below})
    connect(&parts.jobs, &SessionJobs::evaluated, tabs, &PageTabs::setEvaluation);
  connectCharts(parts);
}

void ResultColumn::connectPicture(const WindowParts& parts) {
  connect(&parts.positions, &PositionTabs::rowEntered, m_picture, &ArcChart::setHighlighted);
  connect(&parts.jobs, &SessionJobs::evaluated, m_picture,
          [this](const SharedEvaluation& evaluation) { m_picture->setEvaluation(*evaluation); });
  connect(&parts.jobs, &SessionJobs::headlineChanged, m_picture,
          [this](const Headline& headline) { m_picture->plot()->setHeadline(headline); });
}

void ResultColumn::connectCharts(const WindowParts& parts) {
  for (ChartFiles* files : m_widget->findChildren<ChartFiles*>())
    connect(files, &ChartFiles::fileWanted, &parts.exports, &ExportFlow::saveChart);
  for (PlotWidget* chart : m_widget->findChildren<PlotWidget*>()) {
    connect(chart, &PlotWidget::sightingActivated, this, &ResultColumn::select);
    connect(chart, &PlotWidget::sightingStepped, this, [this](std::size_t position, std::size_t row) {
      emit revealWanted({.position = position, .reading = row}, false);
    });
    connect(&parts.document, &SessionDocument::changed, chart, [chart](const SessionChange& change) {
      if (change.kind == SessionChange::Kind::Everything) chart->showWhole();
    });
  }
}

std::pair<PageTabs*, int> ResultColumn::tab(std::string_view id) const {
  int beside = 0, below = 0;
  for (const PageInfo& info : allPages()) {
    const bool isBeside = info.side == PageSide::Beside;
    int& index = isBeside ? beside : below;
    if (info.id == id) return {isBeside ? m_beside : m_below, index};
    ++index;
  }
  Q_UNREACHABLE();
}

void ResultColumn::showPage(std::string_view id) {
  const auto [tabs, index] = tab(id);
  tabs->showPage(index);
}

void ResultColumn::select(std::size_t position, std::size_t row) {
  emit revealWanted({.position = position, .reading = row, .field = "horizontal"}, true);
}

void ResultColumn::commit() {
  panel<KnownSizesPanel>()->commitOpenEditor();
}

bool ResultColumn::reveal(const Place& place, bool takeFocus) {
  const auto known = knownAt(place);
  const bool isEffect = place.field == "model.effects" || place.field.starts_with("own_effects");
  if (!known && !isEffect) return false;
  const auto [tabs, index] = tab(known ? "known-sizes" : "effects");
  if (known) panel<KnownSizesPanel>()->reveal(*known);
  tabs->setCurrentIndex(index);
  if (known && takeFocus) panel<KnownSizesPanel>()->setFocus();
  return true;
}

}  // namespace alidade::ui
