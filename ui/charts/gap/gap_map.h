#pragma once

#include <vector>

#include "core/evaluation/gap.h"
#include "ui/charts/gap/bar_rows.h"

namespace alidade::ui {

/// The location of a gap: one bar for every division of the readings, filled by parts as long as their
/// shares. Larger shares have stronger colours. Divisions with one part are omitted.
class GapMap : public BarRows {
  Q_OBJECT

 public:
  explicit GapMap(QWidget* parent = nullptr);

  void setShares(const std::vector<GapShare>& shares);
  std::string numbers() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  int pictureHeight() const override;
  QString aboutAt(const QPoint& point) const override;

 private:
  struct Part {
    QString name;
    double share = 0;  ///< 0…1
  };
  struct Bar {
    QString by;
    std::vector<Part> parts;
  };

  QRect barArea(std::size_t row) const;
  QRect partArea(std::size_t row, std::size_t part) const;
  void paintPart(QPainter& painter, const QRect& area, const Part& part) const;

  std::vector<Bar> m_bars;
};

}  // namespace alidade::ui
