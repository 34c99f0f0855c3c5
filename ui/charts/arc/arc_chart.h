#pragma once

#include "ui/charts/plotting/plot_widget.h"
#include "ui/charts/plotting/row_choice.h"

namespace alidade::ui {

class ArcPlot;

/// Both fitted arcs in true proportion with the sighted points, on the screen.
class ArcChart : public PlotWidget {
  Q_OBJECT

 public:
  explicit ArcChart(QWidget* parent = nullptr);

  ArcPlot* plot() const { return m_plot; }
  void choose(const RowChoice& choice);

  QString fileName() const override { return QStringLiteral("arcs"); }

 protected:
  void addChoices(QMenu& menu) override;

 private:
  explicit ArcChart(ArcPlot* plot, QWidget* parent);

  ArcPlot* m_plot;  // owned by the base
};

}  // namespace alidade::ui
