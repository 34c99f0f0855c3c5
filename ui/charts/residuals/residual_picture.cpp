#include "ui/charts/residuals/residual_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/observation/half_turn.h"
#include "ui/charts/plotting/evaluation_pictures.h"

namespace alidade::ui {
namespace {

const Sighting* sightingOf(const ArcMeasurement& arc, std::size_t index, std::size_t row) {
  if (index < arc.sightings.size() && arc.sightings[index].row == row) return &arc.sightings[index];
  const auto found = std::find_if(arc.sightings.begin(), arc.sightings.end(),
                                  [row](const Sighting& sighting) { return sighting.row == row; });
  return found == arc.sightings.end() ? nullptr : &*found;
}

DrawnResidual drawnResidual(const ArcMeasurement& arc, const Sighting& sighting, double arcAngle) {
  return {.ref = {arc.position, sighting.row},
          .axisDeg = arc.axisDeg,
          .repeat = arc.repeat,
          .circle = CircleRead::Horizontal,
          .point = sighting.point,
          .round = sighting.round,
          .face = sighting.face,
          .order = sighting.sequence + 1,
          .elevation = sighting.e.degrees(),
          .azimuth = sighting.a.degrees(),
          .slider = unwrappedSliderCoordinate(arcAngle, arc.axisDeg).degrees()};
}

void addArc(ResidualPicture& picture, const ArcMeasurement& arc, const ArcFit& fit) {
  for (std::size_t i = 0; i < fit.residuals.size(); ++i) {
    const SightingResidual& residual = fit.residuals[i];
    const Sighting* sighting = sightingOf(arc, i, residual.row);
    if (!sighting) continue;
    DrawnResidual drawn = drawnResidual(arc, *sighting, residual.arcAngle);
    drawn.arcsec = residual.horizontal.arcseconds();
    drawn.standardised = residual.horizontalStandardised;
    picture.residuals.push_back(drawn);
    drawn.circle = CircleRead::Vertical;
    drawn.arcsec = residual.vertical.arcseconds();
    drawn.standardised = residual.verticalStandardised;
    picture.residuals.push_back(drawn);
  }
}

/// Adds the slider residuals. Only the joint fit of all positions treats slider readings as observations.
void addSliders(ResidualPicture& picture, const Measurement& measurement, const SessionFit& fit) {
  for (const AdjustedReading& reading : fit.joint.readings) {
    if (reading.kind != ReadingKind::Slider) continue;
    const ArcFit& fitted = fit.arcs[reading.arc];
    const auto arc = std::ranges::find(measurement.arcs, fitted.position, &ArcMeasurement::position);
    DrawnResidual drawn =
        drawnResidual(*arc, arc->sightings[reading.sighting], fitted.residuals[reading.sighting].arcAngle);
    drawn.circle = CircleRead::Slider;
    drawn.arcsec = Angle::fromRadians(reading.residual).arcseconds();
    drawn.standardised = reading.standardised(fit.noise.factor);
    picture.residuals.push_back(drawn);
  }
}

/// Sorts the residuals that have a w. Residuals with equal w stay in the order of the readings.
void sortByStandardised(ResidualPicture& picture) {
  const auto& residuals = picture.residuals;
  for (std::uint32_t i = 0; i < residuals.size(); ++i)
    if (std::isfinite(residuals[i].standardised)) picture.byStandardised.push_back(i);
  std::ranges::stable_sort(picture.byStandardised, {},
                           [&](std::uint32_t i) { return residuals[i].standardised; });
}

}  // namespace

ResidualPicture residualPicture(const Evaluation& evaluation) {
  ResidualPicture picture;
  if (!evaluation.examined.measurement) return picture;
  const Measurement& measurement = *evaluation.examined.measurement;
  picture.sigmaHorizontal = measurement.sigmaHorizontal.arcseconds();
  picture.sigmaVertical = measurement.sigmaVertical.arcseconds();
  picture.sigmaSlider = measurement.sigmaSlider.arcseconds();
  picture.residuals.reserve(evaluation.fit.joint.readings.size());
  for (const ArcMeasurement& arc : measurement.arcs) {
    if (const ArcFit* fit = evaluation.fit.arcOfPosition(arc.position)) addArc(picture, arc, *fit);
  }
  addSliders(picture, measurement, evaluation.fit);
  sortByStandardised(picture);
  picture.kinds = RowKinds::of(picture.residuals);
  return picture;
}

double ResidualPicture::sigmaOf(CircleRead circle) const {
  if (circle == CircleRead::Slider) return sigmaSlider;
  return circle == CircleRead::Horizontal ? sigmaHorizontal : sigmaVertical;
}

std::shared_ptr<const ResidualPicture> residualPictureOf(const Evaluation& evaluation) {
  return evaluation.pictures ? evaluation.pictures->residuals
                             : std::make_shared<const ResidualPicture>(residualPicture(evaluation));
}

}  // namespace alidade::ui
