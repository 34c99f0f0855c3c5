#pragma once

#include <QtCharts/QAreaSeries>
#include <QtCharts/QLineSeries>
#include <array>
#include <memory>

#include "ui/charts/plotting/plot.h"
#include "ui/charts/residuals/residual_kinds.h"
#include "ui/charts/residuals/residual_picture.h"
#include "ui/charts/residuals/residual_points.h"

namespace alidade::ui {

/// The chosen residuals, in arcseconds or standardised, along the arc, in the order read, over an angle, or
/// over their normal quantiles. Limits: ±1σ (band) and ±3σ (dashed) of the stated noise or of 1, or the
/// envelope of normal values. Rounds and faces are side by side. Kinds of readings stay distinguishable in
/// grey (ResidualKind).
class ResidualPlot : public Plot {
  Q_OBJECT

 public:
  explicit ResidualPlot(QObject* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation) override;
  void setChoice(const ResidualChoice& choice);
  QString describe(const Mark& mark) const override;
  QString summary() const override;
  QString standard() const override;
  std::string csv() const override;

  const ResidualPicture& picture() const { return *m_picture; }
  const ResidualChoice& choice() const { return m_choice; }

 protected:
  void applyStyle() override;
  QRectF axisRange(const QSizeF& plotArea) const override;
  void placeExtras() override;

 private:
  static constexpr std::size_t mostBands = 3;

  /// ±σ and ±3σ of one circle, or of both if equal.
  struct NoiseBand {
    QLineSeries *top, *bottom;
    QAreaSeries* area;
    QLineSeries *upperLimit, *lowerLimit;
  };
  struct StatedNoise {
    double sigma = 0;  ///< arcseconds; 1 for standardised residuals
    QStringList circles;
  };

  NoiseBand addNoiseBand();
  void showNoise(const NoiseBand& band, double sigma, const QRectF& range);
  void showEnvelope(const QRectF& range);
  void draw();
  void reckonExtent();
  void reckonNoise();
  void showTitles();
  void showLegend();
  std::vector<LegendEntry> kindEntries() const;
  std::vector<LegendEntry> noiseEntries() const;
  bool isOver(ResidualChoice::Over over) const { return m_choice.over == over; }

  std::shared_ptr<const ResidualPicture> m_picture = std::make_shared<const ResidualPicture>();
  ResidualChoice m_choice;
  ResidualChoice m_drawn;  ///< the part available in the picture
  ResidualKinds m_kinds;
  RowSlots m_slots;
  double m_unit = 0;  // unit of the style, which sets the shift of marks
  NormalEnvelope m_envelope;
  std::vector<StatedNoise> m_noise;  // the largest σ first
  std::size_t m_unchecked = 0;       // chosen, but without a standardised residual
  QRectF m_extent{0, -10, 180, 20};  // extent of what is drawn
  std::array<NoiseBand, mostBands>
      m_bands;          // the largest σ first, so that smaller ones are drawn over it; owned by the chart
  NoiseBand m_normal;   // envelope of normal values; likewise
  QLineSeries* m_line;  // zero, or the normal line
};

}  // namespace alidade::ui
