#include "ui/charts/plotting/tolerance_picture.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

/// Height of the coloured ground as a share of the font's height; the figures are below it.
constexpr double groundShare = 0.9;

class ScalePainter {
 public:
  ScalePainter(QPainter& painter, const QRectF& area, const ToleranceScale& scale,
               const ToleranceColours& colours)
      : m_painter(painter),
        m_scale(scale),
        m_colours(colours),
        m_metrics(colours.font),
        m_ground(area.left() + 1, area.top() + 1, area.width() - 2, groundShare * m_metrics.height()),
        m_line(m_metrics.height() / 12) {}

  void paint() {
    paintGround();
    paintSize();
    paintInterval();
    paintLimit();
  }

 private:
  double at(double length) const { return m_ground.left() + length / m_scale.end() * m_ground.width(); }
  void fill(double from, double to, double share, const QColor& colour) {
    const double height = share * m_ground.height();
    m_painter.fillRect(QRectF(at(from), m_ground.center().y() - height / 2, at(to) - at(from), height),
                       colour);
  }
  void upright(double length, double share, double width) {
    const double half = share * m_ground.height() / 2, x = at(length), y = m_ground.center().y();
    m_painter.setPen(QPen(m_colours.text, width, Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(QPointF(x, y - half), QPointF(x, y + half));
  }

  void paintGround() {
    fill(0, m_scale.tolerance, 1, m_colours.within);
    fill(m_scale.tolerance, m_scale.end(), 1, m_colours.beyond);
    m_painter.setPen(QPen(m_colours.frame, m_line));
    m_painter.drawRect(m_ground);
  }
  void paintSize() { fill(0, m_scale.size, 0.34, m_colours.size); }
  void paintInterval() {
    const double y = m_ground.center().y();
    m_painter.setPen(QPen(m_colours.text, 1.5 * m_line, Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(QPointF(at(m_scale.low()), y), QPointF(at(m_scale.high()), y));
    upright(m_scale.low(), 0.5, 1.5 * m_line);
    upright(m_scale.high(), 0.5, 1.5 * m_line);
    upright(m_scale.size, 0.7, 3 * m_line);
  }
  void paintLimit() {
    upright(m_scale.tolerance, 1.25, 2 * m_line);
    m_painter.setFont(m_colours.font);
    m_painter.setPen(m_colours.text);
    const QString figure = plainNumberText(m_scale.tolerance) + QStringLiteral(" mm");
    //: the limit on a scale; %1: "2.5 mm"
    const QString named = QCoreApplication::translate("ToleranceScale", "tolerance %1").arg(figure);
    const double space = 2 * m_metrics.averageCharWidth();
    const double from = writeBelow(QStringLiteral("0"), 0, m_ground.left()) + space;
    const QString name = QString::fromStdString(m_scale.name);
    const double half = m_metrics.horizontalAdvance(name) / 2;
    const double most = m_ground.right() - space;
    // The name is centred below its mark or omitted; the word "tolerance" gives way to the name.
    const auto isClear = [&](const QString& text) {
      const auto [left, right] = spanBelow(text, m_scale.tolerance, from);
      const double mark = at(m_scale.size);
      const bool isInside = mark - half >= from && mark + half <= most;
      return isInside && (mark + half + space <= left || mark - half - space >= right);
    };
    const bool isRoom = m_metrics.horizontalAdvance(named) < m_ground.width() / 3;
    const bool isNamed = isRoom && (isClear(named) || !isClear(figure));
    writeBelow(isNamed ? named : figure, m_scale.tolerance, from);
    if (isClear(isNamed ? named : figure)) writeBelow(name, m_scale.size, from);
  }
  /// The left and right end of a text centred below a length, but between `from` and the ground's end.
  std::pair<double, double> spanBelow(const QString& text, double length, double from) const {
    const double width = m_metrics.horizontalAdvance(text);
    const double left = std::max(from, std::min(at(length) - width / 2, m_ground.right() - width));
    return {left, left + width};
  }
  /// Returns where the text ends.
  double writeBelow(const QString& text, double length, double from) {
    const auto [left, right] = spanBelow(text, length, from);
    m_painter.drawText(QPointF(left, m_ground.bottom() + m_line + m_metrics.ascent()), text);
    return right;
  }

  QPainter& m_painter;
  const ToleranceScale& m_scale;
  const ToleranceColours& m_colours;
  QFontMetricsF m_metrics;
  QRectF m_ground;
  double m_line;
};

}  // namespace

void paintToleranceScale(QPainter& painter, const QRectF& area, const ToleranceScale& scale,
                         const ToleranceColours& colours) {
  ScalePainter(painter, area, scale, colours).paint();
}

double heightOfToleranceScale(const QFont& font) {
  return (groundShare + 1.15) * QFontMetricsF(font).height() + 2;
}

}  // namespace alidade::ui
