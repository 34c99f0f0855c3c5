#pragma once

#include <array>
#include <vector>

#include "core/evaluation/gap.h"
#include "ui/charts/gap/bar_rows.h"
#include "ui/charts/residuals/residual_picture.h"

namespace alidade::ui {

/// The remaining residuals, in σ of the circle, in one strip for each argument: the slider coordinate s, the
/// elevation e and the time t. Labels mark the ends of the residuals' range and zero. Bands show where the
/// model is valid without the forms of the strip's argument.
class LeftoverStrips : public BarRows {
  Q_OBJECT

 public:
  explicit LeftoverStrips(QWidget* parent = nullptr);

  void setGap(const Gap& gap);
  std::string numbers() const override;
  /// The parts of a strip where the model is valid, in widget units.
  std::vector<QRect> bands(std::size_t strip) const;

  struct Label {
    QString text;
    QRect area;  ///< in widget units, centred on the height of its value
  };
  /// The labels of a strip from the top: the upper end of the range, zero, the lower end.
  std::array<Label, 3> labels(std::size_t strip) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  int pictureHeight() const override;
  QString aboutAt(const QPoint& point) const override;

 private:
  static constexpr std::size_t strips = 3;
  struct Point {
    std::array<double, strips> at;  ///< s and e in degrees, t as a share of the session
    DrawnResidual residual;
    double sigmas = 0;
  };
  struct Axis {
    double low = 0, high = 1;
    std::vector<std::array<double, 2>> clean;
  };

  int stripHeight() const { return 5 * fontMetrics().height(); }
  QString reachText(double sigmas) const;
  /// The vertical place of a residual, in widget units.
  double y(std::size_t strip, double sigmas) const;
  QRect area(std::size_t strip) const;
  double x(std::size_t strip, double at) const;
  QPointF placeOf(std::size_t strip, const Point& point) const;
  void paintStrip(QPainter& painter, std::size_t strip) const;
  void paintScale(QPainter& painter, std::size_t strip) const;

  std::vector<Point> m_points;
  std::array<Axis, strips> m_axes;
  double m_reach = 1;  ///< residual at the upper end, in σ, a multiple of 0.1
};

}  // namespace alidade::ui
