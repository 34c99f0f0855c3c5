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

/// The chosen residuals, in arcseconds or standardised, along the arc, in the order read, over an angle, over
/// their normal quantiles, or stacked in a histogram. Limits: ±1σ (band) and ±3σ (dashed) of the stated noise
/// or, if standardised, of σ = 1; the envelope of normal values; or the curve of their expected numbers.
/// Rounds and faces are side by side. Kinds of readings stay distinguishable in grey (ResidualKind).
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
  double leastYStep() const override { return isOver(ResidualChoice::Over::Count) ? 1 : 0; }
  void placeExtras() override;

 private:
  static constexpr std::size_t mostBands = 3;

  /// ±σ and ±3σ of one circle, or of all circles with this σ.
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
  void showArea(const QRectF& range);
  void showLine(const QRectF& range);
  void draw();
  std::vector<Mark> marksWithin(double reach);
  std::size_t countUnchecked() const;
  double reckonReach() const;
  void reckonExtent(double reach);
  void reckonNoise();
  void showTitles();
  void showLegend();
  std::vector<LegendEntry> kindEntries() const;
  std::vector<LegendEntry> noiseEntries() const;
  std::vector<LegendEntry> classEntries() const;
  QString unitText(const QString& number) const;
  std::string classesCsv() const;
  bool isOver(ResidualChoice::Over over) const { return m_choice.over == over; }

  std::shared_ptr<const ResidualPicture> m_picture = std::make_shared<const ResidualPicture>();
  ResidualChoice m_choice;
  ResidualChoice m_drawn;  ///< the part of the choice available in the picture
  ResidualKinds m_kinds;
  RowSlots m_slots;
  std::vector<ResidualPoint> m_points;  ///< including points beyond a range set by hand
  ResidualClasses m_classes;            ///< classes of a histogram
  double m_unit = 0;                    // unit of the style, which sets the shift of marks
  NormalEnvelope m_envelope;
  std::vector<StatedNoise> m_noise;  // the largest σ first
  std::size_t m_unchecked = 0;       // number of chosen residuals without a w
  std::size_t m_beyond = 0;          // number of points beyond a range set by hand
  QRectF m_extent{0, -10, 180, 20};  // extent of what is drawn
  std::array<NoiseBand, mostBands>
      m_bands;          // the largest σ first, below the bands of smaller σ; owned by the chart
  NoiseBand m_area;     // envelope of normal values, or bars; owned by the chart
  QLineSeries* m_line;  // zero, the normal line, or the curve of expected numbers
};

}  // namespace alidade::ui
