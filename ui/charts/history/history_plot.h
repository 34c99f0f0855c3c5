#pragma once

#include <QGraphicsSimpleTextItem>
#include <vector>

#include "core/series/history/history.h"
#include "core/series/history/history_sentences.h"
#include "ui/charts/plotting/plot.h"

namespace alidade::ui {

/// A control chart over dates: values with bars of ± U, the centre line or the reported levels or trend,
/// limits of each value and of three times the observed scatter, the exponentially weighted average with its
/// limits, and the tolerance. The dates of steps and a chosen baseline are marked.
class HistoryPlot : public Plot {
  Q_OBJECT

 public:
  explicit HistoryPlot(QObject* parent = nullptr);

  void setEvaluation(const Evaluation&) override {}  // the plot shows many sessions
  /// `quantity`: the common name of the quantity. An empty history shows only a sentence.
  void setHistory(const History& history, const QString& quantity, const std::string& unit);
  const History& history() const { return m_history; }

  QString describe(const Mark& mark) const override;
  QString summary() const override;
  QString standard() const override;
  std::string csv() const override;

 protected:
  void applyStyle() override;
  QRectF axisRange(const QSizeF& plotArea) const override;
  std::vector<Tick> xTicks(double low, double high, std::size_t most) const override;
  QString widestXLabel() const override { return QStringLiteral("2000-00-00"); }
  void placeExtras() override;

 private:
  void draw();
  void drawLevels();
  void drawTolerance();
  void label(double year, const QString& text);
  bool hasBaseline() const;
  void reckonExtent();
  void showLegend();
  double yearOf(const DatedValue& value) const;

  History m_history;
  QString m_quantity;
  std::string m_unit;
  double m_scale = 1;  ///< factor from the unit of the values to the axis, a power of ten
  QRectF m_extent{0, -1, 1, 2};
  std::vector<Stick> m_sticks;
  struct Label {
    double year = 0;
    QGraphicsSimpleTextItem* item = nullptr;  ///< owned by the chart
  };
  std::vector<Label> m_labels;  ///< labels of the baseline and the steps, from left to right
};

}  // namespace alidade::ui
