#pragma once

#include "ui/charts/plotting/plot_widget.h"
#include "ui/charts/residuals/residual_choice.h"

namespace alidade::ui {

class ResidualPlot;

/// The residuals of the readings on the screen; a menu chooses which are drawn. The user's settings keep the
/// choice.
class ResidualChart : public PlotWidget {
  Q_OBJECT

 public:
  explicit ResidualChart(QWidget* parent = nullptr);

  ResidualPlot* plot() const { return m_plot; }
  /// Draws the choice, and keeps it for the next window.
  void choose(const ResidualChoice& choice);

  QString fileName() const override { return QStringLiteral("residuals"); }

 signals:
  void chosen();

 protected:
  void addChoices(QMenu& menu) override;

 private:
  explicit ResidualChart(ResidualPlot* plot, QWidget* parent);

  void addCircles(QMenu& menu);

  ResidualPlot* m_plot;  // owned by the base
};

}  // namespace alidade::ui
