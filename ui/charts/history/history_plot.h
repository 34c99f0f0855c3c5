#pragma once

#include <QGraphicsSimpleTextItem>
#include <vector>

#include "core/series/history/history.h"
#include "core/series/history/history_sentences.h"
#include "ui/charts/plotting/plot.h"

namespace alidade::ui {

/// A control chart over the year and its parts: values with bars of 2 u, reported levels or trend, limits of
/// ± 3 u for each value and of three times the observed scatter, and the exponentially weighted average with
/// its limits. Steps have dates.
class HistoryPlot : public Plot {
  Q_OBJECT

 public:
  explicit HistoryPlot(QObject* parent = nullptr);

  void setEvaluation(const Evaluation&) override {}  // the plot shows many sessions
  /// `quantity`: its common name. An empty history shows only a sentence.
  void setHistory(const History& history, const QString& quantity, const std::string& unit);
  const History& history() const { return m_history; }

  QString describe(const Mark& mark) const override;
  QString summary() const override;
  QString standard() const override;
  std::string csv() const override;

 protected:
  void applyStyle() override;
  QRectF axisRange(const QSizeF& plotArea) const override;
  void placeExtras() override;

 private:
  void draw();
  void drawLevels();
  void reckonExtent();
  void showLegend();
  double yearOf(const DatedValue& value) const;

  History m_history;
  QString m_quantity;
  std::string m_unit;
  double m_scale = 1;  ///< power of ten of the axis
  QRectF m_extent{0, -1, 1, 2};
  std::vector<Stick> m_sticks;
  std::vector<QGraphicsSimpleTextItem*> m_dates;  ///< labels of the steps; owned by the chart
};

}  // namespace alidade::ui
