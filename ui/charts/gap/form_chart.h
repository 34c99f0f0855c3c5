#pragma once

#include "ui/charts/gap/form_plot.h"
#include "ui/charts/plotting/plot_widget.h"

namespace alidade::ui {

/// A form on the screen. The wheel scrolls the page behind it, and enlarges while Ctrl is pressed.
class FormChart : public PlotWidget {
  Q_OBJECT

 public:
  explicit FormChart(QWidget* parent = nullptr);

  FormPlot* plot() const { return m_plot; }
  void setForm(const Gap& gap, std::size_t index);

  QString fileName() const override { return QStringLiteral("form"); }
  QSize minimumSizeHint() const override { return {240, 230}; }
  QSize sizeHint() const override { return {420, 270}; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  explicit FormChart(FormPlot* plot, QWidget* parent);

  FormPlot* m_plot;  // owned by the base
};

}  // namespace alidade::ui
