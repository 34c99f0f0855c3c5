#pragma once

#include <optional>
#include <vector>

#include "core/evaluation/gap.h"
#include "ui/charts/gap/bar_rows.h"

namespace alidade::ui {

/// The figures of each closure, and a bar from zero to the misclosure, with the band of ± U. With
/// causes in the model, a hollow circle shows the new misclosure. Lengths are in units of each closure's U,
/// so closures of any size share a scale; an arrow marks values beyond the scale.
class ClosureBars : public BarRows {
  Q_OBJECT

 public:
  static constexpr double scaleEnd = 4;  ///< the scale is from −scaleEnd to +scaleEnd, in units of U

  explicit ClosureBars(QWidget* parent = nullptr);

  void setGap(const Gap& gap);
  std::string numbers() const override;
  bool isEmpty() const { return m_rows.empty(); }
  /// The strip for the bar of closure `row`.
  QRect strip(std::size_t row) const;
  /// The x, in widget units, of a misclosure `inU`, in units of its U; clamped to the ends of the scale.
  double x(double inU) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  int pictureHeight() const override;
  QString aboutAt(const QPoint& point) const override;

 private:
  struct Value {
    QString figures, sigmas;
    double inU = 0;
    Closure closure = {};
  };
  struct Row {
    QString name, about;
    Value before;
    std::optional<Value> after;
  };

  int lineHeight() const { return fontMetrics().height() + 1; }
  int stripHeight() const { return fontMetrics().height() - 1; }
  int top(std::size_t row) const;
  int sigmasWidth() const;
  void paintFigures(QPainter& painter, int top, const QString& caption, const Value& value) const;
  void paintStrip(QPainter& painter, std::size_t row) const;
  void paintScale(QPainter& painter) const;

  std::vector<Row> m_rows;
  double m_coverage = 0.95;
};

}  // namespace alidade::ui
