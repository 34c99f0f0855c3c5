#include "ui/charts/gap/leftover_strips.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/base/round_numbers.h"
#include "core/exchange/csv_text.h"
#include "ui/charts/plotting/plot_style.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

constexpr std::size_t mostMarkers = 2000;  // above this number, dots are drawn
constexpr int labelGap = 5;                // between names, labels and strip
using Ranges = std::vector<std::array<double, 2>>;

constexpr std::array arguments{FormArgument::S, FormArgument::Elevation, FormArgument::T};

Ranges common(const Ranges& first, const Ranges& second) {
  Ranges both;
  for (const auto& one : first)
    for (const auto& other : second)
      if (std::max(one[0], other[0]) < std::min(one[1], other[1]))
        both.push_back({std::max(one[0], other[0]), std::min(one[1], other[1])});
  return both;
}

/// The ranges where no form of this argument displaces readings; empty if no form has this argument.
Ranges cleanRanges(const std::vector<FoundForm>& forms, FormArgument of) {
  std::optional<Ranges> ranges;
  for (const FoundForm& found : forms)
    if (found.form.of == of) ranges = ranges ? common(*ranges, found.cleanRange) : found.cleanRange;
  return ranges.value_or(Ranges());
}

QString stripName(std::size_t strip) {
  const QString names[] = {QStringLiteral("s (°)"), QStringLiteral("e (°)"), QStringLiteral("t")};
  return names[strip];
}

}  // namespace

LeftoverStrips::LeftoverStrips(QWidget* parent)
    : BarRows(tr("Leftover along s, e and t"), QStringLiteral("gap-left-over"), parent) {}

void LeftoverStrips::setGap(const Gap& gap) {
  const Evaluation& evaluation = *gap.evaluation;
  const std::shared_ptr<const ResidualPicture> picture = residualPictureOf(evaluation);
  std::map<std::pair<std::size_t, std::size_t>, double> elapsed;
  for (const ArcMeasurement& arc : evaluation.examined.measurement->arcs)
    for (const Sighting& row : arc.sightings) elapsed[{arc.position, row.row}] = row.elapsed;
  m_points.clear();
  m_reach = 1;
  for (const DrawnResidual& residual : picture->residuals) {
    if (residual.circle == CircleRead::Slider) continue;
    const double sigmas = residual.arcsec / picture->sigmaOf(residual.circle);
    const double t = elapsed[{residual.ref.position, residual.ref.row}];
    if (!std::isfinite(sigmas)) continue;
    m_points.push_back({{residual.slider, residual.elevation, t}, residual, sigmas});
    m_reach = std::max(m_reach, std::abs(sigmas));
  }
  for (std::size_t strip = 0; strip < strips; ++strip) {
    Axis axis{.clean = cleanRanges(gap.diagnosis->forms, arguments[strip])};
    const auto [low, high] =
        std::ranges::minmax_element(m_points, {}, [strip](const Point& point) { return point.at[strip]; });
    constexpr double least = 1e-6;  // a smaller range counts as one place: no scale has steps so fine
    if (!m_points.empty() && low->at[strip] + least < high->at[strip]) {
      axis.low = low->at[strip];
      axis.high = high->at[strip];
    }
    m_axes[strip] = axis;
  }
  m_reach = std::ceil(10 * m_reach - 1e-9) / 10;  // rounded up to the decimals of its label
  changeTo(tr("%1 residuals of at most %2 σ").arg(m_points.size()).arg(numberText(m_reach, 1)));
}

std::string LeftoverStrips::numbers() const {
  CsvText csv{"s_deg", "elevation_deg", "session_share", "reading", "residual_per_sigma"};
  for (const Point& point : m_points) {
    csv.number(point.at[0]).number(point.at[1]).number(point.at[2]);
    csv.word(nameOf(point.residual.circle)).number(point.sigmas).endRow();
  }
  return csv.text();
}

int LeftoverStrips::pictureHeight() const {
  return static_cast<int>(strips) * (stripHeight() + fontMetrics().height() + 6) + fontMetrics().height();
}

QRect LeftoverStrips::area(std::size_t strip) const {
  const int left = fontMetrics().horizontalAdvance(stripName(0)) +
                   fontMetrics().horizontalAdvance(reachText(-m_reach)) + 3 * labelGap;
  const int top = static_cast<int>(strip) * (stripHeight() + fontMetrics().height() + 6);
  return {left, top, width() - left - 6, stripHeight()};
}

double LeftoverStrips::x(std::size_t strip, double at) const {
  const Axis& axis = m_axes[strip];
  const QRect room = area(strip).adjusted(5, 0, -5, 0);
  return room.left() + (at - axis.low) / (axis.high - axis.low) * room.width();
}

/// Half a line is free above and below, so that the labels of the ends are inside the strip.
double LeftoverStrips::y(std::size_t strip, double sigmas) const {
  const QRect room = area(strip);
  return room.top() + (room.height() - sigmas / m_reach * (room.height() - fontMetrics().height())) / 2.0;
}

QPointF LeftoverStrips::placeOf(std::size_t strip, const Point& point) const {
  return {x(strip, point.at[strip]), y(strip, point.sigmas)};
}

QString LeftoverStrips::reachText(double sigmas) const {
  return sigmas == 0 ? QStringLiteral("0 σ") : signedNumberText(sigmas, 1) + QStringLiteral(" σ");
}

std::array<LeftoverStrips::Label, 3> LeftoverStrips::labels(std::size_t strip) const {
  const int height = fontMetrics().height(), right = area(strip).left() - labelGap;
  const auto label = [&](double sigmas) {
    const QString text = reachText(sigmas);
    const int width = fontMetrics().horizontalAdvance(text);
    const int top = static_cast<int>(std::lround(y(strip, sigmas) - height / 2.0));
    return Label{text, QRect(right - width, top, width, height)};
  };
  return {label(m_reach), label(0), label(-m_reach)};
}

std::vector<QRect> LeftoverStrips::bands(std::size_t strip) const {
  std::vector<QRect> bands;
  const Axis& axis = m_axes[strip];
  for (const auto& [from, to] : axis.clean) {
    const double left = x(strip, std::clamp(from, axis.low, axis.high));
    const double right = x(strip, std::clamp(to, axis.low, axis.high));
    bands.push_back(QRectF(left, area(strip).top(), right - left, area(strip).height()).toRect());
  }
  return bands;
}

void LeftoverStrips::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t strip = 0; strip < strips; ++strip) {
    paintStrip(painter, strip);
    paintScale(painter, strip);
  }
  const PlotStyle style = screenStyle(palette(), font());
  const bool hasBands = std::ranges::any_of(m_axes, [](const Axis& axis) { return !axis.clean.empty(); });
  const int line = fontMetrics().height();
  const QString says =
      hasBands ? tr("● horizontal  ◆ vertical; grey: the model holds") : tr("● horizontal  ◆ vertical");
  painter.setPen(style.mutedText);
  painter.drawText(QRect(0, height() - line, width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(says, Qt::ElideRight, width()));
}

void LeftoverStrips::paintStrip(QPainter& painter, std::size_t strip) const {
  const PlotStyle style = screenStyle(palette(), font());
  const QRect room = area(strip);
  painter.setPen(style.text);
  painter.drawText(QRect(0, room.top(), room.left(), room.height()), Qt::AlignLeft | Qt::AlignVCenter,
                   stripName(strip));
  painter.fillRect(room, style.background);
  for (const QRect& band : bands(strip)) painter.fillRect(band, style.band);
  for (const double sigmas : {m_reach, 0.0, -m_reach}) {
    painter.setPen(sigmas == 0 ? style.frame : style.grid);
    painter.drawLine(QPointF(room.left(), y(strip, sigmas)), QPointF(room.right(), y(strip, sigmas)));
  }
  painter.setPen(style.mutedText);
  for (const Label& label : labels(strip)) painter.drawText(label.area, Qt::AlignCenter, label.text);
  const bool isCrowded = m_points.size() > mostMarkers;
  for (const Point& point : m_points) {
    const bool isVertical = point.residual.circle == CircleRead::Vertical;
    const Marker marker{.shape = isVertical ? MarkerShape::Diamond : MarkerShape::Circle,
                        .colour = isVertical ? style.lower : style.upper,
                        .inside = style.background,
                        .size = (isVertical ? 4.5 : 3.5) * style.unit()};
    if (isCrowded)
      painter.fillRect(QRectF(placeOf(strip, point), QSizeF(2, 2)), marker.colour);
    else
      drawMarker(&painter, marker, placeOf(strip, point));
  }
}

/// Paints round numbers below the strip.
void LeftoverStrips::paintScale(QPainter& painter, std::size_t strip) const {
  const PlotStyle style = screenStyle(palette(), font());
  const Axis& axis = m_axes[strip];
  const QRect room = area(strip);
  const int wide = fontMetrics().horizontalAdvance(QStringLiteral("−888.8"));
  const double step = roundUp125((axis.high - axis.low) * 2 * wide / std::max(1, room.width()));
  painter.setPen(style.mutedText);
  for (double at = std::ceil(axis.low / step) * step; at <= axis.high + 1e-9 * step; at += step) {
    const int middle = static_cast<int>(std::lround(x(strip, at)));
    painter.drawLine(middle, room.bottom(), middle, room.bottom() + 2);
    const int left = std::clamp(middle - wide / 2, 0, std::max(0, width() - wide));
    painter.drawText(QRect(left, room.bottom() + 3, wide, fontMetrics().height()), Qt::AlignCenter,
                     numberText(at, decimalsOfStep(step)));
  }
}

QString LeftoverStrips::aboutAt(const QPoint& point) const {
  constexpr double reach = 6;
  const Point* nearest = nullptr;
  double least = reach;
  for (std::size_t strip = 0; strip < strips; ++strip)
    for (const Point& one : m_points)
      if (const double off = QLineF(placeOf(strip, one), point).length(); off < least) {
        least = off;
        nearest = &one;
      }
  if (!nearest) return {};
  const DrawnResidual& residual = nearest->residual;
  return sightingText(residual.axisDeg, residual.repeat, residual.point, residual.round, residual.face) +
         u'\n' + tr("%1 circle: %2 σ").arg(circleName(residual.circle), signedNumberText(nearest->sigmas, 1));
}

}  // namespace alidade::ui
