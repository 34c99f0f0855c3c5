#pragma once

#include <vector>

#include "core/evaluation/gap.h"
#include "ui/charts/gap/bar_rows.h"

namespace alidade::ui {

/// The shrinkage of the gap, cause by cause: a bar for the residual rms of each stage (circle readings, scale
/// in arcseconds). The part that the stage removed is faint behind it; a line shows the rms of the stated
/// noise.
class GapWaterfall : public BarRows {
  Q_OBJECT

 public:
  explicit GapWaterfall(QWidget* parent = nullptr);

  void setGap(const Gap& gap);
  std::string numbers() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  int pictureHeight() const override;
  QString aboutAt(const QPoint& point) const override;

 private:
  struct Bar {
    QString label, rms, chiSquare, about;
    GapStage stage;
    double before = 0, after = 0;  ///< arcseconds
    bool isModelled = true;
  };
  struct Layout;

  Layout layOut() const;
  void paintScale(QPainter& painter, const Layout& layout) const;
  void paintNoise(QPainter& painter, const Layout& layout) const;
  void paintBar(QPainter& painter, const Layout& layout, std::size_t row) const;

  std::vector<Bar> m_bars;
  double m_noise = 0;
};

}  // namespace alidade::ui
