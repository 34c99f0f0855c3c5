#pragma once

#include "ui/charts/history/history_plot.h"
#include "ui/charts/plotting/plot_widget.h"

namespace alidade::ui {

/// A control chart on the screen. Activating a value emits `sightingActivated(0, index)`.
class HistoryChart : public PlotWidget {
  Q_OBJECT

 public:
  explicit HistoryChart(QWidget* parent = nullptr);

  void setHistory(const History& history, const QString& quantity, const std::string& unit);
  HistoryPlot* plot() const { return m_plot; }

  QString fileName() const override { return QStringLiteral("history"); }

 private:
  explicit HistoryChart(HistoryPlot* plot, QWidget* parent);

  HistoryPlot* m_plot;  // owned by the base
};

}  // namespace alidade::ui
