#include "ui/charts/residuals/residual_plot.h"

#include <algorithm>
#include <cmath>

#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

MarkerShape shapeOf(CircleRead circle) {
  return circle == CircleRead::Horizontal ? MarkerShape::Circle : MarkerShape::Diamond;
}

/// What is drawn with one marker.
struct ResidualKind {
  int axisDeg, time;
  CircleRead circle;
};

constexpr std::array<ResidualKind, 8> residualKinds{{{0, 1, CircleRead::Horizontal},
                                                     {0, 1, CircleRead::Vertical},
                                                     {0, 2, CircleRead::Horizontal},
                                                     {0, 2, CircleRead::Vertical},
                                                     {180, 1, CircleRead::Horizontal},
                                                     {180, 1, CircleRead::Vertical},
                                                     {180, 2, CircleRead::Horizontal},
                                                     {180, 2, CircleRead::Vertical}}};

/// Index into `residualKinds`.
std::size_t kindOf(const DrawnResidual& residual) {
  return (residual.axisDeg == 0 ? 0 : 4) + (residual.time > 1 ? 2 : 0) +
         (residual.circle == CircleRead::Horizontal ? 0 : 1);
}

QString circleName(CircleRead circle) {
  return circle == CircleRead::Horizontal ? QStringLiteral("horizontal") : QStringLiteral("vertical");
}

constexpr std::array<Qt::PenStyle, 2> limitStyles{Qt::DotLine, Qt::DashLine};

}  // namespace

ResidualPlot::ResidualPlot(QObject* parent)
    : Plot(parent), m_bands{addNoiseBand(), addNoiseBand()}, m_zero(new QLineSeries) {
  addSeries(m_zero);
  setTitles(QStringLiteral("slider coordinate s (°): φ at 0°, −φ at 180°"), QStringLiteral("residual (″)"));
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
  m_picture = evaluation.residuals ? evaluation.residuals
                                   : std::make_shared<const ResidualPicture>(residualPicture(evaluation));
  m_extent = extent();
  setMessage(m_picture->isEmpty() ? QStringLiteral("No arc fitted yet: no residuals.") : QString());
  std::vector<Mark> marks;
  marks.reserve(m_picture->residuals.size());
  for (const DrawnResidual& residual : m_picture->residuals) {
    marks.push_back({{residual.slider, residual.arcsec}, kindOf(residual), residual.ref});
  }
  markerLayer().setMarks(std::move(marks));
  showLegend();
  rearrange();
}

void ResidualPlot::showLegend() {
  std::vector<LegendEntry> entries;
  std::array<bool, residualKinds.size()> isThere{};
  for (const DrawnResidual& residual : m_picture->residuals) isThere[kindOf(residual)] = true;
  for (std::size_t i = 0; i < residualKinds.size(); ++i) {
    if (!isThere[i]) continue;
    const auto& [axisDeg, time, circle] = residualKinds[i];
    entries.push_back({style().marker(axisDeg, shapeOf(circle), time),
                       positionText(axisDeg, time) + u' ' + circleName(circle)});
  }
  if (!m_picture->isEmpty()) {
    for (LegendEntry& entry : noiseEntries()) entries.push_back(std::move(entry));
  }
  legendItem().setEntries(std::move(entries));
}

std::vector<LegendEntry> ResidualPlot::noiseEntries() const {
  const double unit = style().unit();
  const auto limitPen = [&](std::size_t band) { return QPen(style().limit, 1.2 * unit, limitStyles[band]); };
  const auto sigmaText = [](double sigma) { return plainNumberText(sigma) + QChar(0x2033); };
  if (m_picture->oneSigma()) {
    const QString sigma = sigmaText(m_picture->sigmaHorizontal);
    return {{style().band, QStringLiteral("±1σ, stated σ = ") + sigma}, {limitPen(1), QStringLiteral("±3σ")}};
  }
  const bool verticalLarger = m_picture->sigmaVertical > m_picture->sigmaHorizontal;
  const QString larger = verticalLarger ? QStringLiteral("vertical") : QStringLiteral("horizontal");
  const QString smaller = verticalLarger ? QStringLiteral("horizontal") : QStringLiteral("vertical");
  const double smallSigma = std::min(m_picture->sigmaHorizontal, m_picture->sigmaVertical);
  return {{style().band, QStringLiteral("±1σ %1, stated σ = %2").arg(smaller, sigmaText(smallSigma))},
          {limitPen(1), QStringLiteral("±3σ")},
          {style().outerBand,
           QStringLiteral("±1σ %1, stated σ = %2").arg(larger, sigmaText(m_picture->largestSigma()))},
          {limitPen(0), QStringLiteral("±3σ")}};
}

void ResidualPlot::applyStyle() {
  const double unit = style().unit();
  const std::array<QColor, 2> colours{style().outerBand, style().band};
  for (std::size_t i = 0; i < m_bands.size(); ++i) {
    m_bands[i].area->setPen(Qt::NoPen);
    m_bands[i].area->setBrush(colours[i]);
    for (QLineSeries* limit : {m_bands[i].upperLimit, m_bands[i].lowerLimit}) {
      limit->setPen(QPen(style().limit, 1.2 * unit, limitStyles[i]));
    }
  }
  m_zero->setPen(QPen(style().frame, 0.8 * unit));
  std::vector<Marker> markers;
  for (const auto& [axisDeg, time, circle] : residualKinds)
    markers.push_back(style().marker(axisDeg, shapeOf(circle), time));
  markerLayer().setMarkers(std::move(markers));
  showLegend();
}

QRectF ResidualPlot::extent() const {
  double left = 0, right = 180;
  for (const DrawnResidual& residual : m_picture->residuals) {
    left = std::min(left, residual.slider - 5);
    right = std::max(right, residual.slider + 5);
  }
  double reach = std::max(m_picture->largestResidual(), 3 * m_picture->largestSigma()) * 1.12;
  if (!(reach > 0) || !std::isfinite(reach)) reach = 10;
  return QRectF(left, -reach, right - left, 2 * reach);
}

QRectF ResidualPlot::axisRange(const QSizeF&) const {
  return m_extent;
}

void ResidualPlot::placeExtras() {
  const QRectF range = sceneFromAxes().inverted().mapRect(plotArea());
  const double larger = m_picture->isEmpty() ? 0 : m_picture->largestSigma();
  const double smaller =
      m_picture->isEmpty() ? 0 : std::min(m_picture->sigmaHorizontal, m_picture->sigmaVertical);
  showNoise(m_bands[0], m_picture->oneSigma() ? 0 : larger, range.left(), range.right());
  showNoise(m_bands[1], smaller, range.left(), range.right());
  m_zero->replace(QList<QPointF>{{range.left(), 0}, {range.right(), 0}});
  m_zero->setVisible(!m_picture->isEmpty());
}

void ResidualPlot::showNoise(const NoiseBand& band, double sigma, double left, double right) {
  band.top->replace(QList<QPointF>{{left, sigma}, {right, sigma}});
  band.bottom->replace(QList<QPointF>{{left, -sigma}, {right, -sigma}});
  band.upperLimit->replace(QList<QPointF>{{left, 3 * sigma}, {right, 3 * sigma}});
  band.lowerLimit->replace(QList<QPointF>{{left, -3 * sigma}, {right, -3 * sigma}});
  for (QAbstractSeries* series :
       {static_cast<QAbstractSeries*>(band.area), static_cast<QAbstractSeries*>(band.upperLimit),
        static_cast<QAbstractSeries*>(band.lowerLimit)}) {
    series->setVisible(sigma > 0);
  }
}

QString ResidualPlot::describe(const Mark& mark) const {
  for (const DrawnResidual& residual : m_picture->residuals) {
    if (residual.ref != mark.ref || kindOf(residual) != mark.kind) continue;
    return QStringLiteral(
               "Axis at %1, point %2, round %3, face %4\n%5 circle: %6″ at s = %7°, standardised w = %8")
        .arg(positionText(residual.axisDeg, residual.time))
        .arg(residual.point)
        .arg(residual.round)
        .arg(residual.face)
        .arg(circleName(residual.circle), signedNumberText(residual.arcsec, 1),
             numberText(residual.slider, 2), signedNumberText(residual.standardised, 2));
  }
  return {};
}

QString ResidualPlot::summary() const {
  if (m_picture->isEmpty()) return message();
  return QStringLiteral("Residuals of %1 readings, at most %2")
      .arg(m_picture->residuals.size())
      .arg(arcsecText(m_picture->largestResidual()));
}

}  // namespace alidade::ui
