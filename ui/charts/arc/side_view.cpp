#include "ui/charts/arc/side_view.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/base/round_numbers.h"
#include "core/wording/size_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

struct SideViewText {
  Q_DECLARE_TR_FUNCTIONS(SideViewText)
};

QString nameOf(int axisDeg) {
  return axisDeg == 0 ? QStringLiteral("O1") : QStringLiteral("O2");
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

/// The first of these that fits: name and figure, the figure alone, the name alone; otherwise empty.
QStringList SideView::titleThatFits() const {
  const QString name = SideViewText::tr("Along the axis");
  const QString figure =
      QStringLiteral("Δz = ") + qText(sizeWithExpanded(m_offset->across, m_offset->acrossExpanded, "mm"));
  const QFontMetricsF metrics(m_style.font);
  for (const QStringList& parts : {QStringList{name, figure}, QStringList{figure}, QStringList{name}}) {
    double width = line() * static_cast<double>(parts.size());
    for (const QString& part : parts) width += metrics.horizontalAdvance(part);
    if (width <= m_square.width()) return parts;
  }
  return {};
}

double SideView::line() const {
  return QFontMetricsF(m_style.font).height();
}

/// Sets a scale that shows both centres with U, and a tolerance of up to three times the centres' extent.
void SideView::updateScale() {
  m_scale = 0;
  m_title.clear();
  update();
  if (!m_offset || m_style.font.pixelSize() <= 0) return;
  constexpr double fewestLines = 4, mostOfTolerance = 3;
  if (std::min(m_square.width(), m_square.height()) < fewestLines * line()) return;
  m_title = titleThatFits();
  m_picture =
      m_square.adjusted(0.4 * line(), (m_title.isEmpty() ? 0.3 : 1.3) * line(), -0.4 * line(), -1.3 * line());
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

/// The name is beside its centre, towards the axis; above the upper and below the lower centre.
QRectF SideView::nameRect(int axisDeg) const {
  const bool isFirst = axisDeg == 0;
  const QPointF at = isFirst ? centre() : 2 * m_picture.center() - centre();
  const QFontMetricsF metrics(m_style.font);
  const double width = metrics.horizontalAdvance(nameOf(axisDeg)), gap = 0.4 * line();
  const bool isLeft = at.x() <= m_picture.center().x();
  const bool isAbove = at.y() == m_picture.center().y() ? isFirst : at.y() < m_picture.center().y();
  const double left = isLeft ? at.x() + gap : at.x() - gap - width;
  const double top = isAbove ? at.y() - line() : at.y();
  return {std::clamp(left, m_picture.left(), m_picture.right() - width),
          std::clamp(top, m_picture.top(), m_picture.bottom() - line()), width, line()};
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
  painter->setPen(m_style.text);
  for (const int axisDeg : {0, 180}) painter->drawText(nameRect(axisDeg), Qt::AlignCenter, nameOf(axisDeg));
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
  const double above = m_square.top() + 0.2 * line() + metrics.ascent();
  if (!m_title.isEmpty()) painter.drawText(QPointF(left, above), m_title.first());
  if (m_title.size() > 1)
    painter.drawText(QPointF(right - metrics.horizontalAdvance(m_title.last()), above), m_title.last());
  const double length = roundDown125(m_square.width() * 0.3 / m_scale), end = left + length * m_scale;
  const QString figure = plainNumberText(length) + QStringLiteral(" mm");
  const double behind = end + gap + metrics.horizontalAdvance(figure);
  const bool hasBar = behind <= right;  // a figure is never shortened
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
