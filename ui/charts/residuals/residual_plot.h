#pragma once

#include <QtCharts/QAreaSeries>
#include <QtCharts/QLineSeries>
#include <array>
#include <memory>

#include "ui/charts/plotting/plot.h"
#include "ui/charts/residuals/residual_picture.h"

namespace alidade::ui {

/// The residual of every reading in arcseconds along the arc (standardised where one is pointed at), with ±1σ
/// (band) and ±3σ (dashed) of the stated noise. Colour and filling tell the axis position, a ring that it was
/// measured again, the shape tells the circle, so the kinds stay apart in grey.
class ResidualPlot : public Plot {
  Q_OBJECT

 public:
  explicit ResidualPlot(QObject* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation) override;
  QString describe(const Mark& mark) const override;
  QString summary() const override;

  const ResidualPicture& picture() const { return *m_picture; }

 protected:
  void applyStyle() override;
  QRectF axisRange(const QSizeF& plotArea) const override;
  void placeExtras() override;

 private:
  /// ±1σ and ±3σ of one circle, or of both where they are the same.
  struct NoiseBand {
    QLineSeries *top, *bottom;
    QAreaSeries* area;
    QLineSeries *upperLimit, *lowerLimit;
  };

  NoiseBand addNoiseBand();
  void showNoise(const NoiseBand& band, double sigma, double left, double right);
  QRectF extent() const;
  void showLegend();
  std::vector<LegendEntry> noiseEntries() const;

  std::shared_ptr<const ResidualPicture> m_picture = std::make_shared<const ResidualPicture>();
  QRectF m_extent{0, -10, 180, 20};  // of the picture: s in degrees, residuals in arcseconds
  std::array<NoiseBand, 2>
      m_bands;  // the larger σ first, so that the smaller is drawn over it; owned by the chart
  QLineSeries* m_zero;
};

}  // namespace alidade::ui
