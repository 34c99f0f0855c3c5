#include "ui/charts/plotting/legend.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

namespace alidade::ui {
namespace {

struct Measures {
  double line, sign, gap, between;

  explicit Measures(const QFont& font) {
    const QFontMetricsF metrics(font);
    line = metrics.height() * 1.15;
    sign = metrics.height() * 1.3;
    gap = metrics.height() * 0.3;
    between = metrics.height() * 0.9;
  }
};

double signWidth(const LegendEntry& entry, const Measures& measures) {
  if (std::holds_alternative<std::monostate>(entry.sign)) return 0;
  const auto* marker = std::get_if<Marker>(&entry.sign);
  return measures.sign * (!marker ? 1 : marker->ringed || marker->struck ? 0.75 : 0.55) + measures.gap;
}

}  // namespace

void Legend::setStyle(const PlotStyle& style) {
  m_style = style;
  update();
}

void Legend::setEntries(std::vector<LegendEntry> entries) {
  m_entries = std::move(entries);
  m_places.clear();
  update();
}

double Legend::layOut(double width, double corner) {
  const Measures measures(m_style.font);
  const QFontMetricsF metrics(m_style.font);
  prepareGeometryChange();
  m_places.clear();
  QPointF at;
  double bottom = 0;
  for (const LegendEntry& entry : m_entries) {
    const double needed = signWidth(entry, measures) + metrics.horizontalAdvance(entry.text);
    if (at.x() > 0 && at.x() + needed > width - (at.y() > 0 ? 0 : corner))
      at = QPointF(0, at.y() + measures.line);
    m_places.push_back(at);
    at.rx() += needed + measures.between;
    bottom = at.y() + measures.line;
  }
  m_bounds = QRectF(0, 0, width, bottom);
  return bottom;
}

void Legend::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const Measures measures(m_style.font);
  const QFontMetricsF metrics(m_style.font);
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setFont(m_style.font);
  for (std::size_t i = 0; i < m_places.size(); ++i) {
    const LegendEntry& entry = m_entries[i];
    const double sign = signWidth(entry, measures);
    const QPointF at = m_places[i];
    paintSign(painter, entry, QRectF(at.x(), at.y(), std::max(0.0, sign - measures.gap), metrics.height()));
    painter->setPen(m_style.text);
    painter->drawText(QPointF(at.x() + sign, at.y() + metrics.ascent()), entry.text);
  }
}

void Legend::paintSign(QPainter* painter, const LegendEntry& entry, const QRectF& box) const {
  if (const auto* marker = std::get_if<Marker>(&entry.sign)) {
    drawMarker(painter, *marker, box.center());
  } else if (const auto* pen = std::get_if<QPen>(&entry.sign)) {
    painter->setPen(*pen);
    painter->drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
  } else if (const auto* band = std::get_if<QColor>(&entry.sign)) {
    painter->fillRect(box.adjusted(0, box.height() * 0.15, 0, -box.height() * 0.15), *band);
  }
}

}  // namespace alidade::ui
