#include "ui/charts/residuals/residual_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/exchange/csv_text.h"
#include "ui/charts/plotting/clipping.h"
#include "ui/charts/plotting/row_choice.h"
#include "ui/text/entry_text.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

using Over = ResidualChoice::Over;

constexpr std::array<Qt::PenStyle, 3> limitStyles{Qt::DashDotLine, Qt::DotLine, Qt::DashLine};

bool isAlike(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::max(a, b);
}

QList<QPointF> inside(const QList<QPointF>& points, const QRectF& range) {
  const auto pieces = clipped(points, range);
  return pieces.isEmpty() ? QList<QPointF>() : pieces.first();
}

/// A curve from left to right, cut at the left and right end of the range and clamped to its top and bottom.
QList<QPointF> heldIn(const QList<QPointF>& curve, const QRectF& range) {
  QList<QPointF> points = inside(curve, {range.left(), -1e9, range.width(), 2e9});
  for (QPointF& point : points) point.setY(std::clamp(point.y(), range.top(), range.bottom()));
  return points;
}

}  // namespace

ResidualPlot::ResidualPlot(QObject* parent)
    : Plot(parent),
      m_bands{addNoiseBand(), addNoiseBand(), addNoiseBand()},
      m_area(addNoiseBand()),
      m_line(new QLineSeries) {
  addSeries(m_line);
  showTitles();
}

ResidualPlot::NoiseBand ResidualPlot::addNoiseBand() {
  NoiseBand band{new QLineSeries(this), new QLineSeries(this), nullptr, new QLineSeries, new QLineSeries};
  band.area = new QAreaSeries(band.top, band.bottom);
  addSeries(band.area);
  addSeries(band.upperLimit);
  addSeries(band.lowerLimit);
  return band;
}

void ResidualPlot::setEvaluation(const Evaluation& evaluation) {
  m_picture = residualPictureOf(evaluation);
  draw();
}

void ResidualPlot::setChoice(const ResidualChoice& choice) {
  if (choice == m_choice) return;
  m_choice = choice;
  showTitles();
  showWhole();
  draw();
}

void ResidualPlot::showTitles() {
  const auto x = [this] {
    switch (m_choice.over) {
      case Over::Order:
        return tr("row in the order read (time)");
      case Over::Elevation:
        return tr("elevation e (°), up positive");
      case Over::Azimuth:
        return tr("azimuth a (°), right positive");
      case Over::Normal:
        return tr("normal quantile");
      case Over::Slider:
      case Over::Count:
        break;
    }
    return tr("slider coordinate s (°): φ at 0°, −φ at 180°");
  };
  const QString residual = m_choice.showsStandardised() ? tr("standardised w") : tr("residual (″)");
  if (isOver(Over::Count)) return setTitles(residual, tr("number of residuals"));
  setTitles(x(), residual);
}

void ResidualPlot::draw() {
  m_drawn = m_choice;
  m_drawn.rows = m_choice.rows.among(m_picture->kinds);
  const bool isSpread = !isOver(Over::Order) && !isOver(Over::Normal) && !isOver(Over::Count);
  m_slots = isSpread ? RowSlots(m_picture->kinds, m_drawn.rows) : RowSlots();
  m_points = residualPoints(*m_picture, m_drawn);
  m_kinds = {};
  for (const ResidualPoint& point : m_points) m_kinds.take(m_picture->residuals[point.index]);
  m_unchecked = m_drawn.showsStandardised() ? countUnchecked() : 0;
  m_envelope = isOver(Over::Normal) ? normalEnvelope(m_points.size()) : NormalEnvelope();
  setMessage(m_picture->isEmpty() ? tr("No arc fitted yet: no residuals.")
             : m_points.empty()   ? tr("There are no readings of the kind selected for the chart.")
                                  : QString());
  reckonNoise();
  const double reach = reckonReach();
  m_classes = isOver(Over::Count) ? stackInClasses(m_points, *m_picture, m_drawn, reach) : ResidualClasses();
  showMarks(marksWithin(reach));
  reckonExtent(reach);
  applyStyle();
  rearrange();
}

std::size_t ResidualPlot::countUnchecked() const {
  return static_cast<std::size_t>(std::ranges::count_if(m_picture->residuals, [&](const DrawnResidual& one) {
    return m_drawn.takes(one.circle) && m_drawn.rows.takes(one.round, one.face) &&
           !std::isfinite(one.standardised);
  }));
}

std::vector<Mark> ResidualPlot::marksWithin(double reach) {
  std::vector<Mark> marks;
  marks.reserve(m_points.size());
  const double unit = m_unit = style().unit();
  for (const ResidualPoint& point : m_points) {
    const DrawnResidual& residual = m_picture->residuals[point.index];
    if (isOver(Over::Count) ? point.at.y() == 0 : std::abs(point.at.y()) > reach) continue;
    marks.push_back({point.at,
                     m_kinds.take(residual),
                     residual.ref,
                     point.index,
                     {unit * m_slots.shift(residual.round, residual.face), 0}});
  }
  m_beyond = m_points.size() - marks.size();
  return marks;
}

void ResidualPlot::reckonNoise() {
  m_noise.clear();
  if (m_points.empty() || isOver(Over::Normal)) return;
  if (m_drawn.isStandardised) {
    m_noise.push_back({1, {}});
    return;
  }
  for (const CircleRead circle : {CircleRead::Horizontal, CircleRead::Vertical, CircleRead::Slider}) {
    if (!m_drawn.takes(circle)) continue;
    if (circle == CircleRead::Slider && std::ranges::none_of(m_kinds.all(), [](const ResidualKind& kind) {
          return kind.circle == CircleRead::Slider;
        }))
      continue;
    const double sigma = m_picture->sigmaOf(circle);
    const auto same =
        std::ranges::find_if(m_noise, [&](const StatedNoise& one) { return isAlike(one.sigma, sigma); });
    if (same == m_noise.end())
      m_noise.push_back({sigma, {circleName(circle)}});
    else
      same->circles.append(circleName(circle));
  }
  std::ranges::stable_sort(m_noise, std::greater(), &StatedNoise::sigma);
}

/// The largest residual shown: set by hand, or large enough for all residuals.
double ResidualPlot::reckonReach() const {
  if (m_drawn.reach() > 0) return m_drawn.reach();
  double reach = 0;
  for (const ResidualPoint& point : m_points)
    reach = std::max(reach, std::abs(isOver(Over::Count) ? point.at.x() : point.at.y()));
  for (const StatedNoise& noise : m_noise) reach = std::max(reach, 3 * noise.sigma);
  for (const QPointF& point : m_envelope.upper) reach = std::max(reach, std::abs(point.y()));
  reach *= isOver(Over::Count) ? 1 : 1.12;
  return reach > 0 && std::isfinite(reach) ? reach : 10;
}

void ResidualPlot::reckonExtent(double reach) {
  if (isOver(Over::Count)) {
    const Histogram& histogram = m_classes.histogram;
    auto highest = static_cast<double>(histogram.largestCount());
    for (const QPointF& point : m_classes.curve) highest = std::max(highest, point.y());
    constexpr double least = 2.2;  // leaves room for 0, 1 and 2
    m_extent = QRectF(histogram.first, 0, histogram.end() - histogram.first, std::max(1.12 * highest, least));
    return;
  }
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for (const ResidualPoint& point : m_points) {
    left = std::min(left, point.at.x());
    right = std::max(right, point.at.x());
  }
  if (isOver(Over::Slider)) {
    left = std::min(0.0, left - 5);
    right = std::max(180.0, right + 5);
  } else if (m_points.empty()) {
    left = 0;
    right = 1;
  } else {
    const double beside = std::max(0.05 * (right - left), isOver(Over::Order) ? 1 : 1e-3);
    left -= beside;
    right += beside;
  }
  m_extent = QRectF(left, -reach, right - left, 2 * reach);
}

void ResidualPlot::showLegend() {
  std::vector<LegendEntry> entries;
  if (!m_points.empty()) {
    entries = kindEntries();
    for (LegendEntry& entry : isOver(Over::Count) ? classEntries() : noiseEntries())
      entries.push_back(std::move(entry));
  }
  legendItem().setEntries(std::move(entries));
}

std::vector<LegendEntry> ResidualPlot::kindEntries() const {
  std::vector<ResidualKind> kinds = m_kinds.all();
  for (ResidualKind& kind : kinds) kind.isFaceTwo = false;
  const auto key = [](const ResidualKind& kind) {
    return std::tuple(kind.axisDeg, kind.isAgain, kind.circle);
  };
  std::ranges::sort(kinds, {}, key);
  const auto isTwice = [&key](const ResidualKind& one, const ResidualKind& other) {
    return key(one) == key(other);
  };
  kinds.erase(std::unique(kinds.begin(), kinds.end(), isTwice), kinds.end());
  std::vector<LegendEntry> entries;
  for (const ResidualKind& kind : kinds) entries.push_back({kind.marker(style()), kind.text()});
  for (LegendEntry& entry : rowEntries(style(), m_picture->kinds, m_drawn.rows, m_slots.areApart()))
    entries.push_back(std::move(entry));
  if (m_unchecked > 0) entries.push_back({{}, tr("not drawn: %1 without redundancy").arg(m_unchecked)});
  if (m_beyond > 0)
    entries.push_back({{},
                       //: %1: number of residuals, %2: range, such as 10″
                       tr("not drawn: %1 beyond ±%2")
                           .arg(m_beyond)
                           .arg(unitText(plainNumberText(isOver(Over::Count) ? m_classes.histogram.end()
                                                                             : m_drawn.reach())))});
  return entries;
}

QString ResidualPlot::unitText(const QString& number) const {
  return m_drawn.showsStandardised() ? number : number + QChar(0x2033);
}

std::vector<LegendEntry> ResidualPlot::classEntries() const {
  std::vector<LegendEntry> entries;
  entries.push_back(
      {style().band,
       tr("number in classes of %1").arg(unitText(plainNumberText(m_classes.histogram.width)))});
  if (m_classes.curve.isEmpty()) return entries;
  QStringList sigmas;
  for (const StatedNoise& noise : m_noise) {
    const QString sigma = unitText(plainNumberText(noise.sigma));
    sigmas.append(m_noise.size() == 1 ? sigma
                                      //: one or several circles, and their σ
                                      : tr("%1 %2").arg(listText(noise.circles), sigma));
  }
  entries.push_back({QPen(style().text, 1.4 * style().unit()),
                     m_drawn.isStandardised ? tr("expected if normal, σ = 1")
                                            : tr("expected for the stated σ = %1").arg(listText(sigmas))});
  return entries;
}

std::vector<LegendEntry> ResidualPlot::noiseEntries() const {
  const double unit = style().unit();
  const auto limit = [&](Qt::PenStyle pen) { return QPen(style().limit, 1.2 * unit, pen); };
  if (isOver(Over::Normal)) {
    std::vector<LegendEntry> entries{{QPen(style().frame, unit), tr("normal")}};
    if (!m_envelope.lower.isEmpty())
      entries.insert(entries.begin(), {style().band, tr("95 % band if normal")});
    return entries;
  }
  std::vector<LegendEntry> entries;
  // The smallest σ first.
  for (std::size_t i = m_noise.size(); i-- > 0;) {
    const StatedNoise& noise = m_noise[i];
    const QColor colour = i + 1 == m_noise.size() ? style().band : style().outerBand;
    const QPen pen = limit(limitStyles[i + mostBands - m_noise.size()]);
    if (m_drawn.isStandardised) {
      entries.push_back({colour, tr("±1")});
      entries.push_back({pen, tr("±3: 3 of 1000 lie beyond")});
      continue;
    }
    const QString sigma = plainNumberText(noise.sigma) + QChar(0x2033);
    entries.push_back({colour, m_noise.size() == 1
                                   ? tr("±1σ, stated σ = %1").arg(sigma)
                                   : tr("±1σ %1, stated σ = %2").arg(listText(noise.circles), sigma)});
    entries.push_back({pen, tr("±3σ")});
  }
  return entries;
}

void ResidualPlot::applyStyle() {
  const double unit = style().unit();
  if (unit != m_unit) return draw();  // which calls this function again
  for (std::size_t i = 0; i < m_bands.size(); ++i) {
    m_bands[i].area->setPen(Qt::NoPen);
    m_bands[i].area->setBrush(i + 1 == m_bands.size() ? style().band : style().outerBand);
    for (QLineSeries* limit : {m_bands[i].upperLimit, m_bands[i].lowerLimit}) {
      limit->setPen(QPen(style().limit, 1.2 * unit, limitStyles[i]));
    }
  }
  const bool isCount = isOver(Over::Count);
  m_area.area->setPen(isCount ? QPen(style().frame, 0.8 * unit) : QPen(Qt::NoPen));
  m_area.area->setBrush(style().band);
  m_line->setPen(isCount ? QPen(style().text, 1.4 * unit) : QPen(style().frame, 0.8 * unit));
  std::vector<Marker> drawn;
  for (const ResidualKind& kind : m_kinds.all()) drawn.push_back(kind.marker(style()));
  markerLayer().setMarkers(std::move(drawn));
  showLegend();
}

QRectF ResidualPlot::axisRange(const QSizeF&) const {
  return m_extent;
}

void ResidualPlot::placeExtras() {
  const QRectF range = sceneFromAxes().inverted().mapRect(plotArea());
  const std::size_t first = mostBands - m_noise.size();
  for (std::size_t i = 0; i < mostBands; ++i)
    showNoise(m_bands[i], i < first || isOver(Over::Count) ? 0 : m_noise[i - first].sigma, range);
  showArea(range);
  showLine(range);
}

void ResidualPlot::showLine(const QRectF& range) {
  const double reach = std::max(std::abs(range.left()), std::abs(range.right()));
  m_line->replace(isOver(Over::Count)
                      ? heldIn(m_classes.curve, range)
                      : inside(isOver(Over::Normal) ? QList<QPointF>{{-reach, -reach}, {reach, reach}}
                                                    : QList<QPointF>{{range.left(), 0}, {range.right(), 0}},
                               range));
  m_line->setVisible(!m_points.empty());
}

/// Draws ±σ as a band and ±3σ as lines; nothing for `sigma` = 0.
void ResidualPlot::showNoise(const NoiseBand& band, double sigma, const QRectF& range) {
  const auto level = [&](double y) { return QList<QPointF>{{range.left(), y}, {range.right(), y}}; };
  const double high = std::clamp(sigma, range.top(), range.bottom());
  const double low = std::clamp(-sigma, range.top(), range.bottom());
  band.top->replace(level(high));
  band.bottom->replace(level(low));
  band.upperLimit->replace(level(3 * sigma));
  band.lowerLimit->replace(level(-3 * sigma));
  band.area->setVisible(high > low);
  band.upperLimit->setVisible(sigma > 0 && 3 * sigma <= range.bottom());
  band.lowerLimit->setVisible(sigma > 0 && -3 * sigma >= range.top());
}

void ResidualPlot::showArea(const QRectF& range) {
  const QList<QPointF>& upper = isOver(Over::Count) ? m_classes.outline : m_envelope.upper;
  const QList<QPointF> top = heldIn(upper, range);
  m_area.top->replace(top);
  m_area.bottom->replace(isOver(Over::Count) && !top.isEmpty()
                             ? QList<QPointF>{{top.first().x(), range.top()}, {top.last().x(), range.top()}}
                             : heldIn(m_envelope.lower, range));
  m_area.area->setVisible(m_area.top->count() > 1 && m_area.bottom->count() > 1);
  m_area.upperLimit->setVisible(false);
  m_area.lowerLimit->setVisible(false);
}

QString ResidualPlot::describe(const Mark& mark) const {
  if (mark.index >= m_picture->residuals.size()) return {};
  const DrawnResidual& residual = m_picture->residuals[mark.index];
  QString text =
      sightingText(residual.axisDeg, residual.repeat, residual.point, residual.round, residual.face);
  const QString value = signedNumberText(residual.arcsec, 1);
  text += u'\n';
  text += residual.circle == CircleRead::Slider
              ? tr("slider: %1″").arg(value)
              : tr("%1 circle: %2″").arg(circleName(residual.circle), value);
  if (isOver(Over::Order)) text += tr(", row %1 in the order of reading").arg(residual.order);
  if (isOver(Over::Elevation)) text += tr(" at e = %1°").arg(numberText(residual.elevation, 3));
  if (isOver(Over::Azimuth)) text += tr(" at a = %1°").arg(numberText(residual.azimuth, 3));
  if (isOver(Over::Slider) || isOver(Over::Normal) || isOver(Over::Count))
    text += tr(" at s = %1°").arg(numberText(residual.slider, 2));
  text += tr(", standardised w = %1").arg(signedNumberText(residual.standardised, 2));
  if (isOver(Over::Normal)) text += tr(", normal quantile %1").arg(signedNumberText(mark.at.x(), 2));
  const auto in = isOver(Over::Count) ? m_classes.histogram.classOf(mark.at.x()) : std::nullopt;
  if (in)
    text += u'\n' + tr("class from %1 to %2: %3 residuals, expected %4")
                        .arg(unitText(plainNumberText(m_classes.histogram.lower(*in))),
                             unitText(plainNumberText(m_classes.histogram.lower(*in + 1))))
                        .arg(m_classes.histogram.counts[*in])
                        .arg(numberText(m_classes.expected(*in), 1));
  return text;
}

QString ResidualPlot::summary() const {
  if (!message().isEmpty()) return message();
  if (isOver(Over::Count))
    return tr("Histogram of %1 residuals in classes %2 wide, at most %3 per class")
        .arg(m_points.size())
        .arg(unitText(plainNumberText(m_classes.histogram.width)))
        .arg(m_classes.histogram.largestCount());
  double largest = 0;
  for (const ResidualPoint& point : m_points) largest = std::max(largest, std::abs(point.at.y()));
  return tr("Residuals of %1 readings, at most %2")
      .arg(m_points.size())
      .arg(m_choice.showsStandardised() ? numberText(largest, 2) : arcsecText(largest));
}

QString ResidualPlot::standard() const {
  switch (m_choice.over) {
    case Over::Order:
      return tr(
          "Should be: the same even band from the first row to the last; no drift, no step between rounds.");
    case Over::Normal:
      return tr(
          "Should be: the marks follow the line inside the band; a reading outside the band at an end may be "
          "misread.");
    case Over::Count:
      return tr(
          "Should be: the bars follow the curve. If they are wider, the stated σ is too small; two humps or "
          "a long tail show a gap or a misread reading.");
    case Over::Slider:
    case Over::Elevation:
    case Over::Azimuth:
      break;
  }
  return m_choice.isStandardised ? tr("Should be: an even band about 0, two thirds within ±1, hardly any "
                                      "beyond ±3; no wave, no slope.")
                                 : tr("Should be: an even band about 0, two thirds within ±1σ, hardly any "
                                      "beyond ±3σ; no wave, no slope.");
}

std::string ResidualPlot::classesCsv() const {
  const std::string unit = m_drawn.showsStandardised() ? "" : "_arcsec";
  CsvText csv{"lower" + unit, "upper" + unit, "count", "expected"};
  const Histogram& histogram = m_classes.histogram;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    csv.number(histogram.lower(i)).number(histogram.lower(i + 1));
    csv.count(static_cast<long long>(histogram.counts[i])).number(m_classes.expected(i)).endRow();
  }
  return csv.text();
}

std::string ResidualPlot::csv() const {
  if (isOver(Over::Count)) return classesCsv();
  const bool isNormal = isOver(Over::Normal);
  CsvText csv{"axis_deg",
              "turn",
              "point",
              "round",
              "face",
              "reading",
              "order",
              "s_deg",
              "elevation_deg",
              "azimuth_deg",
              "residual_arcsec",
              "standardised_residual",
              isNormal ? "normal_quantile" : "sigma_arcsec"};
  for (const ResidualPoint& point : m_points) {
    const DrawnResidual& residual = m_picture->residuals[point.index];
    csv.count(residual.axisDeg).count(residual.repeat).count(residual.point).count(residual.round);
    csv.count(residual.face).word(nameOf(residual.circle)).count(static_cast<long long>(residual.order));
    csv.number(residual.slider).number(residual.elevation).number(residual.azimuth);
    csv.number(residual.arcsec).number(residual.standardised);
    csv.number(isNormal ? point.at.x() : m_picture->sigmaOf(residual.circle)).endRow();
  }
  return csv.text();
}

}  // namespace alidade::ui
