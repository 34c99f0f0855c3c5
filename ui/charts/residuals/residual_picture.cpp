#include "ui/charts/residuals/residual_picture.h"

#include <algorithm>
#include <cmath>

#include "core/observation/half_turn.h"

namespace alidade::ui {
namespace {

/// s of an arc angle, degrees in [−90, 270): the guideway's half circle without a seam.
double sliderDegrees(double arcAngle, int axisDeg) {
  const Angle angle = Angle::fromRadians(sliderCoordinateOf(arcAngle, axisDeg));
  return wrapped(angle, Angle::fromDegrees(90)).degrees();
}

const Sighting* sightingOf(const ArcMeasurement& arc, std::size_t index, std::size_t row) {
  if (index < arc.sightings.size() && arc.sightings[index].row == row) return &arc.sightings[index];
  const auto found = std::find_if(arc.sightings.begin(), arc.sightings.end(),
                                  [row](const Sighting& sighting) { return sighting.row == row; });
  return found == arc.sightings.end() ? nullptr : &*found;
}

void addArc(ResidualPicture& picture, const ArcMeasurement& arc, const ArcFit& fit) {
  for (std::size_t i = 0; i < fit.residuals.size(); ++i) {
    const SightingResidual& residual = fit.residuals[i];
    const Sighting* sighting = sightingOf(arc, i, residual.row);
    if (!sighting) continue;
    DrawnResidual drawn{.ref = {arc.position, residual.row},
                        .axisDeg = arc.axisDeg,
                        .time = arc.time,
                        .circle = CircleRead::Horizontal,
                        .point = sighting->point,
                        .round = sighting->round,
                        .face = sighting->face,
                        .slider = sliderDegrees(residual.arcAngle, arc.axisDeg),
                        .arcsec = residual.horizontal.arcseconds(),
                        .standardised = residual.horizontalStandardised};
    picture.residuals.push_back(drawn);
    drawn.circle = CircleRead::Vertical;
    drawn.arcsec = residual.vertical.arcseconds();
    drawn.standardised = residual.verticalStandardised;
    picture.residuals.push_back(drawn);
  }
}

}  // namespace

ResidualPicture residualPicture(const Evaluation& evaluation) {
  ResidualPicture picture;
  if (!evaluation.examined.measurement) return picture;
  const Measurement& measurement = *evaluation.examined.measurement;
  picture.sigmaHorizontal = measurement.sigmaHorizontal.arcseconds();
  picture.sigmaVertical = measurement.sigmaVertical.arcseconds();
  for (const ArcMeasurement& arc : measurement.arcs) {
    if (const ArcFit* fit = evaluation.fit.arcOfPosition(arc.position)) addArc(picture, arc, *fit);
  }
  return picture;
}

bool ResidualPicture::oneSigma() const {
  return std::abs(sigmaHorizontal - sigmaVertical) <= 1e-9 * largestSigma();
}

double ResidualPicture::largestResidual() const {
  double largest = 0;
  for (const DrawnResidual& residual : residuals) largest = std::max(largest, std::abs(residual.arcsec));
  return largest;
}

}  // namespace alidade::ui
