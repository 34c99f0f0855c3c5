#include "ui/charts/residuals/residual_points.h"

#include <algorithm>
#include <cmath>

#include "core/base/normal_order.h"

namespace alidade::ui {
namespace {

double abscissa(const DrawnResidual& residual, ResidualChoice::Over over) {
  switch (over) {
    case ResidualChoice::Over::Order:
      return static_cast<double>(residual.order);
    case ResidualChoice::Over::Elevation:
      return residual.elevation;
    case ResidualChoice::Over::Azimuth:
      return residual.azimuth;
    case ResidualChoice::Over::Slider:
    case ResidualChoice::Over::Normal:
    case ResidualChoice::Over::Count:
      break;
  }
  return residual.slider;
}

bool isTaken(const DrawnResidual& residual, const ResidualChoice& choice) {
  return choice.takes(residual.circle) && choice.rows.takes(residual.round, residual.face);
}

std::vector<ResidualPoint> rankedPoints(const ResidualPicture& picture, const ResidualChoice& choice) {
  std::vector<ResidualPoint> points;
  for (const std::uint32_t i : picture.byStandardised)
    if (isTaken(picture.residuals[i], choice)) points.push_back({{0, picture.residuals[i].standardised}, i});
  for (std::size_t rank = 1; rank <= points.size(); ++rank)
    points[rank - 1].at.setX(normalScore(static_cast<double>(rank), points.size()));
  return points;
}

/// The stated noise of the chosen residuals: one entry for each circle; σ = 1 for standardised residuals.
std::vector<NormalValues> statedNoise(const std::vector<ResidualPoint>& points,
                                      const ResidualPicture& picture, const ResidualChoice& choice) {
  if (choice.isStandardised) return {{points.size(), 1}};
  std::vector<NormalValues> normal;
  for (const CircleRead circle : {CircleRead::Horizontal, CircleRead::Vertical, CircleRead::Slider}) {
    const auto count = std::ranges::count_if(
        points, [&](const ResidualPoint& point) { return picture.residuals[point.index].circle == circle; });
    if (count > 0 && picture.sigmaOf(circle) > 0)
      normal.push_back({static_cast<std::size_t>(count), picture.sigmaOf(circle)});
  }
  return normal;
}

void drawClasses(ResidualClasses& classes) {
  const Histogram& histogram = classes.histogram;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i)
    for (const double x : {histogram.lower(i), histogram.lower(i + 1)})
      classes.outline.append({x, static_cast<double>(histogram.counts[i])});
  if (classes.normal.empty()) return;
  constexpr int pieces = 240;
  const double half = histogram.width / 2;
  for (int i = 0; i <= pieces; ++i) {
    const double x = histogram.first + (histogram.end() - histogram.first) * i / pieces;
    classes.curve.append({x, expectedBetween(classes.normal, x - half, x + half)});
  }
}

}  // namespace

double ResidualClasses::expected(std::size_t index) const {
  return expectedBetween(normal, histogram.lower(index), histogram.lower(index + 1));
}

ResidualClasses stackInClasses(std::vector<ResidualPoint>& points, const ResidualPicture& picture,
                               const ResidualChoice& choice, double reach) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const ResidualPoint& point : points) values.push_back(point.at.x());
  ResidualClasses classes;
  classes.histogram = histogram(values, reach);
  classes.normal = statedNoise(points, picture, choice);
  std::vector<std::size_t> below(classes.histogram.counts.size());
  for (ResidualPoint& point : points)
    if (const auto in = classes.histogram.classOf(point.at.x()))
      point.at = {classes.histogram.lower(*in) + classes.histogram.width / 2,
                  static_cast<double>(below[*in]++) + 0.5};
  drawClasses(classes);
  return classes;
}

std::vector<ResidualPoint> residualPoints(const ResidualPicture& picture, const ResidualChoice& choice) {
  if (choice.over == ResidualChoice::Over::Normal) return rankedPoints(picture, choice);
  std::vector<ResidualPoint> points;
  points.reserve(picture.residuals.size());
  for (std::uint32_t i = 0; i < picture.residuals.size(); ++i) {
    const DrawnResidual& residual = picture.residuals[i];
    const double value = choice.isStandardised ? residual.standardised : residual.arcsec;
    if (!isTaken(residual, choice) || !std::isfinite(value)) continue;
    const bool isCounted = choice.over == ResidualChoice::Over::Count;
    points.push_back({isCounted ? QPointF(value, 0) : QPointF(abscissa(residual, choice.over), value), i});
  }
  return points;
}

NormalEnvelope normalEnvelope(std::size_t count) {
  NormalEnvelope envelope;
  if (count < 2) return envelope;
  // The ranks are closely spaced at the ends, where the envelope bends.
  std::vector<double> ranks;
  const double middle = (static_cast<double>(count) + 1) / 2;
  for (double rank = 1; rank < middle; rank += std::max(0.25, 0.2 * rank)) ranks.push_back(rank);
  const std::size_t half = ranks.size();
  ranks.push_back(middle);
  for (std::size_t i = half; i-- > 0;) ranks.push_back(static_cast<double>(count) + 1 - ranks[i]);
  for (const double rank : ranks) {
    const double x = normalScore(rank, count);
    envelope.lower.append({x, normalOrderQuantile(0.025, rank, count)});
    envelope.upper.append({x, normalOrderQuantile(0.975, rank, count)});
  }
  return envelope;
}

}  // namespace alidade::ui
