#include "ui/charts/arc/side_view.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/base/round_numbers.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

struct SideViewText {
  Q_DECLARE_TR_FUNCTIONS(SideViewText)
};

QString title() {
  return SideViewText::tr("Along the axis");
}

}  // namespace

void SideView::setStyle(const PlotStyle& style) {
  m_style = style;
  updateScale();
}

void SideView::setOffset(const std::optional<CentreOffset>& offset) {
  m_offset = offset;
  updateScale();
}

void SideView::setSquare(const QRectF& square) {
  prepareGeometryChange();
  m_square = square;
  updateScale();
}

bool SideView::hasTitle() const {
  return m_square.width() >= QFontMetricsF(m_style.font).horizontalAdvance(title()) + line();
}

double SideView::line() const {
  return QFontMetricsF(m_style.font).height();
}

/// Shows both centres with U, but no more of the tolerance than three times as much.
void SideView::updateScale() {
  m_scale = 0;
  update();
  if (!m_offset || m_style.font.pixelSize() <= 0) return;
  constexpr double fewestLines = 4, mostOfTolerance = 3;
  if (m_square.width() < fewestLines * line()) return;
  m_picture =
      m_square.adjusted(0.4 * line(), (hasTitle() ? 1.3 : 0.3) * line(), -0.4 * line(), -1.3 * line());
  const auto finite = [](double length) { return std::isfinite(length) ? length : 0; };
  const double up = std::abs(m_offset->inPlane) + finite(m_offset->inPlaneExpanded);
  const double across = std::abs(m_offset->across) + finite(m_offset->acrossExpanded);
  const double tolerance =
      std::min(1.1 * m_offset->tolerance.value_or(0), mostOfTolerance * std::max(up, across));
  m_scale =
      0.46 * std::min(m_picture.height() / std::max({up, tolerance, 1e-6}),
                      m_picture.width() / std::max({across, m_offset->isOfDistance ? tolerance : 0, 1e-6}));
}

QPointF SideView::centre() const {
  return m_picture.center() + m_scale * QPointF(m_offset->across, -m_offset->inPlane);
}

void SideView::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (m_scale <= 0) return;
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setFont(m_style.font);
  painter->setPen(QPen(m_style.frame, 0.8 * m_style.unit()));
  painter->setBrush(m_style.background);
  painter->drawRect(m_square);
  painter->save();
  painter->setClipRect(m_picture, Qt::IntersectClip);
  paintTolerance(*painter);
  paintAxis(*painter);
  paintCentres(*painter);
  painter->restore();
  paintTexts(*painter);
}

void SideView::paintTolerance(QPainter& painter) const {
  if (!m_offset->tolerance) return;
  const double reach = *m_offset->tolerance * m_scale;
  const QPointF axis = m_picture.center();
  painter.setPen(QPen(m_style.limit, m_style.unit(), Qt::DotLine));
  painter.setBrush(m_style.outerBand);
  if (m_offset->isOfDistance)
    painter.drawEllipse(axis, reach, reach);
  else
    painter.drawRect(QRectF(m_picture.left() - 2, axis.y() - reach, m_picture.width() + 4, 2 * reach));
}

void SideView::paintAxis(QPainter& painter) const {
  const QPointF axis = m_picture.center();
  painter.setPen(QPen(m_style.mutedText, m_style.unit(), Qt::DashDotLine));
  painter.drawLine(QPointF(m_picture.left(), axis.y()), QPointF(m_picture.right(), axis.y()));
  painter.drawLine(QPointF(axis.x(), m_picture.top()), QPointF(axis.x(), m_picture.bottom()));
}

void SideView::paintCentres(QPainter& painter) const {
  const QPointF at = centre(), opposite = 2 * m_picture.center() - at;
  const double up = m_offset->inPlaneExpanded * m_scale, across = m_offset->acrossExpanded * m_scale;
  painter.setPen(QPen(m_style.text, m_style.unit()));
  if (std::isfinite(up)) painter.drawLine(at - QPointF(0, up), at + QPointF(0, up));
  if (std::isfinite(across)) painter.drawLine(at - QPointF(across, 0), at + QPointF(across, 0));
  drawMarker(&painter, m_style.marker(180, MarkerShape::Circle), opposite);
  drawMarker(&painter, m_style.marker(0, MarkerShape::Circle), at);
}

void SideView::paintTexts(QPainter& painter) const {
  const QFontMetricsF metrics(m_style.font);
  const double gap = 0.4 * line(), left = m_square.left() + gap, right = m_square.right() - gap;
  const double baseline = m_square.bottom() - gap;
  painter.setPen(m_style.mutedText);
  if (hasTitle()) painter.drawText(QPointF(left, m_square.top() + 0.2 * line() + metrics.ascent()), title());
  const double length = roundDown125(m_square.width() * 0.3 / m_scale), end = left + length * m_scale;
  const QString figure = plainNumberText(length) + QStringLiteral(" mm");
  const double behind = end + gap + metrics.horizontalAdvance(figure);
  const bool hasBar = behind <= right;  // a shortened figure would be another one
  //: an arrow to the side where the theodolite stands
  const QString side = SideViewText::tr("Δz →");
  const double ofSide = right - metrics.horizontalAdvance(side);
  if (!hasBar || behind + gap <= ofSide) painter.drawText(QPointF(ofSide, baseline), side);
  if (!hasBar) return;
  const double bar = baseline - gap;
  painter.setPen(QPen(m_style.text, 1.2 * m_style.unit()));
  painter.drawLine(QPointF(left, bar), QPointF(end, bar));
  painter.drawText(QPointF(end + gap, baseline), figure);
}

}  // namespace alidade::ui
