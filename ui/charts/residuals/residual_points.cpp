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

}  // namespace

std::vector<ResidualPoint> residualPoints(const ResidualPicture& picture, const ResidualChoice& choice) {
  if (choice.over == ResidualChoice::Over::Normal) return rankedPoints(picture, choice);
  std::vector<ResidualPoint> points;
  points.reserve(picture.residuals.size());
  for (std::uint32_t i = 0; i < picture.residuals.size(); ++i) {
    const DrawnResidual& residual = picture.residuals[i];
    const double value = choice.isStandardised ? residual.standardised : residual.arcsec;
    if (isTaken(residual, choice) && std::isfinite(value))
      points.push_back({{abscissa(residual, choice.over), value}, i});
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
