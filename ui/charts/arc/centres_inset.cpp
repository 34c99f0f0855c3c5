#include "ui/charts/arc/centres_inset.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/charts/plotting/round_numbers.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

PlanePoint<double> middle(const DrawnIntersection& i) {
  return {(i.upperCentre.x + i.lowerCentre.x) / 2, (i.upperCentre.y + i.lowerCentre.y) / 2};
}

}  // namespace

void CentresInset::setStyle(const PlotStyle& style) {
  m_style = style;
  updateScale();
}

void CentresInset::setIntersection(const std::optional<DrawnIntersection>& intersection) {
  m_intersection = intersection;
  setVisible(intersection.has_value());
  updateScale();
}

void CentresInset::setSquare(const QRectF& square) {
  prepareGeometryChange();
  m_square = square;
  updateScale();
}

void CentresInset::updateScale() {
  m_scale = 0;
  update();
  if (!m_intersection || m_square.isEmpty() || m_style.font.pixelSize() <= 0) return;
  const double line = QFontMetricsF(m_style.font).height();
  m_picture = m_square.adjusted(1.2 * line, 2.6 * line, -1.2 * line, -1.9 * line);
  if (m_picture.width() < 2 * line || m_picture.height() < 2 * line) return;
  const DrawnIntersection& i = *m_intersection;
  const double expanded = std::isfinite(i.expanded) ? i.expanded : 0;
  const double halfWidth = std::abs(i.upperCentre.x - i.lowerCentre.x) / 2;
  const double halfHeight = std::min(std::abs(i.value) + expanded, 4 * std::abs(i.value) + 1e-6);
  m_scale = std::min(m_picture.width() * 0.4 / std::max(halfWidth, 1e-6),
                     m_picture.height() * 0.46 / std::max(halfHeight, 1e-6));
}

QPointF CentresInset::place(const PlanePoint<double>& point) const {
  const PlanePoint<double> origin = middle(*m_intersection);
  return m_picture.center() + m_scale * QPointF(point.x - origin.x, origin.y - point.y);
}

void CentresInset::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  if (m_scale <= 0) {
    paintBare(painter);
    return;
  }
  painter->setFont(m_style.font);
  painter->setPen(QPen(m_style.frame, 0.8 * m_style.unit()));
  painter->setBrush(m_style.background);
  painter->drawRect(m_square);
  painter->save();
  painter->setClipRect(m_square, Qt::IntersectClip);
  paintAxis(painter);
  // A bar longer than the picture is cut off: title and scale stay readable.
  painter->setClipRect(QRectF(m_square.left(), m_picture.top(), m_square.width(), m_picture.height()),
                       Qt::IntersectClip);
  paintDistance(painter);
  painter->restore();
  paintCentres(painter);
  paintScaleBar(painter);
  paintTitle(painter);
}

void CentresInset::paintBare(QPainter* painter) const {
  if (!m_intersection) return;
  const QFontMetricsF metrics(m_style.font);
  drawMarker(painter,
             {.shape = MarkerShape::Plus, .colour = m_style.text, .inside = {}, .size = 8 * m_style.unit()},
             m_square.center());
  painter->setFont(m_style.font);
  painter->drawText(m_square.center() + QPointF(0.6 * metrics.height(), -0.2 * metrics.height()),
                    QStringLiteral("O1, O2"));
}

void CentresInset::paintAxis(QPainter* painter) const {
  painter->setPen(QPen(m_style.mutedText, m_style.unit(), Qt::DashDotLine));
  const double y = m_picture.center().y();
  painter->drawLine(QPointF(m_square.left(), y), QPointF(m_square.right(), y));
  const QFontMetricsF metrics(m_style.font);
  const QString name = QStringLiteral("axis");
  painter->setPen(m_style.mutedText);
  painter->drawText(QPointF(m_square.right() - metrics.horizontalAdvance(name) - 0.4 * metrics.height(),
                            y - 0.25 * metrics.height()),
                    name);
}

void CentresInset::paintCentres(QPainter* painter) const {
  const QFontMetricsF metrics(m_style.font);
  const auto draw = [&](const PlanePoint<double>& centre, int axisDeg, const QString& name) {
    const QPointF at = place(centre);
    Marker marker = m_style.marker(axisDeg, MarkerShape::Circle);
    drawMarker(painter, marker, at);
    painter->setPen(m_style.text);
    const bool leftSide = at.x() > m_picture.center().x();
    const double shift =
        leftSide ? -metrics.horizontalAdvance(name) - 0.6 * metrics.height() : 0.6 * metrics.height();
    painter->drawText(at + QPointF(shift, metrics.ascent() * 0.4), name);
  };
  draw(m_intersection->lowerCentre, 180, QStringLiteral("O2"));
  draw(m_intersection->upperCentre, 0, QStringLiteral("O1"));
}

void CentresInset::paintDistance(QPainter* painter) const {
  const double unit = m_style.unit();
  const QPointF centre = place(m_intersection->upperCentre);
  const double axis = m_picture.center().y();
  const double reach = std::isfinite(m_intersection->expanded) ? m_intersection->expanded * m_scale : 0;
  painter->setPen(QPen(m_style.text, 2.4 * unit, Qt::SolidLine, Qt::FlatCap));
  painter->drawLine(QPointF(centre.x(), axis), centre);
  // U as an error bar about the end of Δd.
  painter->setPen(QPen(m_style.text, unit));
  painter->drawLine(centre - QPointF(0, reach), centre + QPointF(0, reach));
  for (const double end : {-reach, reach}) {
    const QPointF at = centre + QPointF(0, end);
    painter->drawLine(at - QPointF(4 * unit, 0), at + QPointF(4 * unit, 0));
  }
}

void CentresInset::paintScaleBar(QPainter* painter) const {
  const QFontMetricsF metrics(m_style.font);
  const double length = roundDown125(m_square.width() * 0.4 / m_scale);
  const QString text = plainNumberText(length) + QStringLiteral(" mm");
  const double y = m_square.bottom() - 0.75 * metrics.height();
  const double left = m_square.left() + 0.6 * metrics.height();
  const double right = left + length * m_scale;
  const double tick = 0.25 * metrics.height();
  painter->setPen(QPen(m_style.text, 1.2 * m_style.unit()));
  painter->drawLine(QPointF(left, y), QPointF(right, y));
  for (const double x : {left, right}) painter->drawLine(QPointF(x, y - tick), QPointF(x, y + tick));
  painter->drawText(QPointF(right + 0.5 * metrics.height(), y + metrics.ascent() * 0.4), text);
}

void CentresInset::paintTitle(QPainter* painter) const {
  const QFontMetricsF metrics(m_style.font);
  const double room = m_square.width() - 0.8 * metrics.height();
  QPointF at(m_square.left() + 0.4 * metrics.height(),
             m_square.top() + metrics.ascent() + 0.2 * metrics.height());
  painter->setPen(m_style.text);
  // Of each line the longest wording that fits.
  const DrawnIntersection& i = *m_intersection;
  const QString value = valueWithUncertainty(i.value, i.expanded, QStringLiteral("mm"));
  const QString coverage = QStringLiteral(" (%1 %)").arg(plainNumberText(i.coverage * 100));
  const std::array<QStringList, 2> lines{
      QStringList{QStringLiteral("Centres and axis, enlarged"), QStringLiteral("Centres, enlarged"),
                  QStringLiteral("Centres")},
      QStringList{QStringLiteral("Δd = ") + value + coverage, QStringLiteral("Δd = ") + value, value}};
  for (const QStringList& wordings : lines) {
    const auto fits = std::find_if(wordings.begin(), wordings.end(), [&](const QString& text) {
      return metrics.horizontalAdvance(text) <= room;
    });
    if (fits == wordings.end()) continue;
    painter->drawText(at, *fits);
    at.ry() += metrics.height();
  }
}

}  // namespace alidade::ui
