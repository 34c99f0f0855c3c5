#pragma once

#include <QtCharts/QAreaSeries>
#include <QtCharts/QLineSeries>
#include <array>
#include <vector>

#include "core/diagnosis/result/form.h"
#include "core/evaluation/gap.h"
#include "ui/charts/plotting/plot.h"

namespace alidade::ui {

/// A form as a curve over its argument. At each sighting, a hollow mark is the partial residual without the
/// form, and a filled mark the residual with the form, predicted without this sighting if `isHeldOut`.
/// For an orientation, the two circles differ in colour and shape. Bands show where the model is valid.
class FormPlot : public Plot {
  Q_OBJECT

 public:
  explicit FormPlot(QObject* parent = nullptr);

  void setEvaluation(const Evaluation&) override {}
  /// Shows the form `index` of the diagnosis.
  void setForm(const Gap& gap, std::size_t index);

  QString describe(const Mark& mark) const override;
  QString summary() const override;
  QString standard() const override;
  std::string csv() const override;

  const FoundForm& form() const { return m_form; }
  /// True if at least one sighting took no part in finding the form.
  bool isHeldOut() const;

 protected:
  void applyStyle() override;
  QRectF axisRange(const QSizeF& plotArea) const override;
  void placeExtras() override;
  double leastXStep() const override { return hasLevels() ? 1 : 0; }

 private:
  static constexpr std::size_t mostPieces = 4, mostBands = 3;
  enum Kind : std::size_t { Before, After, BeforeVertical, AfterVertical };
  struct Band {
    QLineSeries *top, *bottom;
    QAreaSeries* area;
  };

  void draw();
  void reckonExtent();
  void showTitles();
  void showLegend();
  Marker markerOf(Kind kind) const;
  bool hasTwoCircles() const { return m_form.form.carrier == FormCarrier::Orientation; }
  bool hasLevels() const { return m_form.form.function == FormFunction::Hysteresis; }
  QList<QList<QPointF>> curves(std::size_t which) const;
  QString valueText(double value) const;

  FoundForm m_form;
  std::vector<QString> m_names;  ///< name of the sighting of each point of the trace
  QRectF m_extent{0, -1, 1, 2};
  std::array<Band, mostBands> m_bands;  // bands and lines are owned by the chart
  std::array<QLineSeries*, 2> m_limits;
  QLineSeries* m_zero;
  std::array<std::array<QLineSeries*, mostPieces>, 2> m_curves;
};

}  // namespace alidade::ui
