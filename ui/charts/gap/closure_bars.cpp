#include "ui/charts/gap/closure_bars.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/exchange/csv_text.h"
#include "core/statement/gap.h"
#include "core/wording/closures.h"
#include "ui/charts/plotting/plot_style.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

constexpr int spaceBelow = 8;
constexpr int key = 16;     ///< room for the sign before a caption
constexpr int margin = 7;   ///< room for arrows and circles at the ends of the scale
constexpr int between = 8;  ///< gap between columns of figures

/// A triangle pointing away from the middle, with its tip at `tip`.
QPainterPath arrow(const QPointF& tip, double direction, double size) {
  QPainterPath path(tip);
  path.lineTo(tip + QPointF(-direction * size, -size / 2));
  path.lineTo(tip + QPointF(-direction * size, size / 2));
  path.closeSubpath();
  return path;
}

bool isBeyond(double inU) {
  return std::abs(inU) > ClosureBars::scaleEnd;
}

Marker circle(const PlotStyle& style) {
  return {.shape = MarkerShape::Circle,
          .colour = style.lower,
          .inside = style.background,
          .filled = false,
          .size = 8 * style.unit()};
}

}  // namespace

ClosureBars::ClosureBars(QWidget* parent)
    : BarRows(tr("What must agree"), QStringLiteral("closures"), parent) {}

std::string ClosureBars::numbers() const {
  CsvText csv{"closure",  "misclosure_mm",  "sigma_mm",         "expanded_mm", "misclosure_per_expanded",
              "after_mm", "after_sigma_mm", "after_expanded_mm"};
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const Row& row : m_rows) {
    const Closure& before = row.before.closure;
    csv.typed(row.name.toStdString()).number(before.value).number(before.sigma);
    csv.number(expandedOf(before, m_coverage)).number(row.before.inU);
    csv.number(row.after ? row.after->closure.value : none)
        .number(row.after ? row.after->closure.sigma : none);
    csv.number(row.after ? expandedOf(row.after->closure, m_coverage) : none).endRow();
  }
  return csv.text();
}

void ClosureBars::setGap(const Gap& gap) {
  m_rows.clear();
  m_coverage = gap.evaluation->examined.measurement->coverage;
  const Statement statement = gapClosures(gap);
  const auto valueOf = [&](const Closure& closure, const std::vector<std::string>& cells, std::size_t first) {
    return Value{.figures = qText(cells[first]),
                 .sigmas = qText(cells[first + 1]),
                 .inU = closure.value / expandedOf(closure, m_coverage),
                 .closure = closure};
  };
  const auto accessibleOf = [](const Value& value) { return listText({value.figures, value.sigmas}); };
  QStringList accessible;
  for (std::size_t i = 0; i < statement.rows.size(); ++i) {
    const ClosureStep& step = gap.diagnosis->closures[i];
    const std::vector<std::string>& cells = statement.rows[i].cells;
    Row row{.name = qText(cells[0]), .about = {}, .before = valueOf(step.before, cells, 1), .after = {}};
    row.about = row.name + QStringLiteral(" = ") + accessibleOf(row.before);
    if (step.after && !gap.diagnosis->causes.empty()) {
      row.after = valueOf(*step.after, cells, 3);
      row.about += tr("; with the causes %1").arg(accessibleOf(*row.after));
    }
    accessible.append(row.about);
    m_rows.push_back(row);
  }
  changeTo(accessible.join(QStringLiteral(". ")));
}

int ClosureBars::top(std::size_t row) const {
  int y = 0;
  for (std::size_t i = 0; i < row; ++i)
    y += (m_rows[i].after ? 2 : 1) * lineHeight() + stripHeight() + spaceBelow;
  return y;
}

int ClosureBars::pictureHeight() const {
  return m_rows.empty() ? 0 : top(m_rows.size()) + 2 * lineHeight();
}

QRect ClosureBars::strip(std::size_t row) const {
  return {0, top(row) + (m_rows[row].after ? 2 : 1) * lineHeight() + 1, width(), stripHeight()};
}

double ClosureBars::x(double inU) const {
  return width() / 2.0 + std::clamp(inU / scaleEnd, -1.0, 1.0) * (width() / 2.0 - margin);
}

int ClosureBars::sigmasWidth() const {
  int widest = 0;
  for (const Row& row : m_rows) {
    widest = std::max(widest, fontMetrics().horizontalAdvance(row.before.sigmas));
    if (row.after) widest = std::max(widest, fontMetrics().horizontalAdvance(row.after->sigmas));
  }
  return widest;
}

void ClosureBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const PlotStyle style = screenStyle(palette(), font());
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const Row& row = m_rows[i];
    const double middle = top(i) + lineHeight() / 2.0;
    painter.fillRect(QRectF(0, middle - 3, key - 6, 6), style.upper);
    paintFigures(painter, top(i), row.name, row.before);
    if (row.after) {
      drawMarker(&painter, circle(style), QPointF((key - 6) / 2.0, middle + lineHeight()));
      paintFigures(painter, top(i) + lineHeight(), tr("with the causes"), *row.after);
    }
    paintStrip(painter, i);
  }
  if (!m_rows.empty()) paintScale(painter);
}

void ClosureBars::paintFigures(QPainter& painter, int top, const QString& caption, const Value& value) const {
  const int sigmas = sigmasWidth(), figures = fontMetrics().horizontalAdvance(value.figures);
  const int edge = width() - sigmas - between;
  const int room = edge - figures - between - key;
  painter.setPen(screenStyle(palette(), font()).text);
  painter.drawText(QRect(key, top, room, lineHeight()), Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(caption, Qt::ElideRight, room));
  painter.drawText(QRect(edge - figures, top, figures, lineHeight()), Qt::AlignRight | Qt::AlignVCenter,
                   value.figures);
  painter.drawText(QRect(width() - sigmas, top, sigmas, lineHeight()), Qt::AlignRight | Qt::AlignVCenter,
                   value.sigmas);
}

void ClosureBars::paintStrip(QPainter& painter, std::size_t row) const {
  const PlotStyle style = screenStyle(palette(), font());
  const QRectF area = strip(row);
  const double middle = area.center().y(), zero = x(0), size = area.height() * 0.9;
  painter.fillRect(area, style.grid);
  painter.fillRect(QRectF(x(-1), area.top(), x(1) - x(-1), area.height()), style.band);
  painter.setPen(QPen(style.frame, 1));
  painter.drawLine(QPointF(zero, area.top()), QPointF(zero, area.bottom()));
  const double before = m_rows[row].before.inU;
  if (std::isfinite(before)) {
    const double direction = before < 0 ? -1 : 1;
    const double end = x(before) - (isBeyond(before) ? direction * size * 0.8 : 0);
    const double length = std::max(2.0, std::abs(end - zero));
    painter.fillRect(
        QRectF(before < 0 ? zero - length : zero, middle - area.height() * 0.25, length, area.height() * 0.5),
        style.upper);
    if (isBeyond(before)) painter.fillPath(arrow({x(before), middle}, direction, size), style.upper);
  }
  if (!m_rows[row].after || !std::isfinite(m_rows[row].after->inU)) return;
  const double after = m_rows[row].after->inU;
  if (!isBeyond(after)) {
    drawMarker(&painter, circle(style), {x(after), middle});
    return;
  }
  painter.setPen(QPen(style.lower, 1.4 * style.unit()));
  painter.setBrush(style.background);
  painter.drawPath(arrow({x(after), middle}, after < 0 ? -1 : 1, size));
}

void ClosureBars::paintScale(QPainter& painter) const {
  const PlotStyle style = screenStyle(palette(), font());
  const int y = top(m_rows.size()) - spaceBelow + 1;
  painter.setPen(style.mutedText);
  for (const auto& [inU, text] : {std::pair(-1.0, QStringLiteral("−U")), std::pair(0.0, QStringLiteral("0")),
                                  std::pair(1.0, QStringLiteral("+U"))})
    painter.drawText(QRectF(x(inU) - 30, y, 60, lineHeight()), Qt::AlignHCenter | Qt::AlignTop, text);
  const bool isCut = std::any_of(m_rows.begin(), m_rows.end(), [](const Row& row) {
    return isBeyond(row.before.inU) || (row.after && isBeyond(row.after->inU));
  });
  QString says = tr("band: ± U at %1 %").arg(plainNumberText(100 * m_coverage));
  if (isCut) says += tr("; arrow: beyond %1 U").arg(plainNumberText(scaleEnd));
  painter.drawText(QRect(0, y + lineHeight(), width(), lineHeight()), Qt::AlignHCenter | Qt::AlignTop, says);
}

QString ClosureBars::aboutAt(const QPoint& point) const {
  for (std::size_t row = 0; row < m_rows.size(); ++row)
    if (point.y() >= top(row) && point.y() <= strip(row).bottom()) return m_rows[row].about;
  return {};
}

}  // namespace alidade::ui
