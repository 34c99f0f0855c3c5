#include "core/adjustment/arc/foot_point.h"

#include <cmath>

#include "core/adjustment/numerics/arc_angle_step.h"
#include "core/observation/half_turn.h"

namespace alidade {

namespace {

double angleOf(const Ratio<double>& ratio) {
  const bool isSmall = std::abs(ratio.above) < smallAngle * ratio.below;
  return isSmall ? angleOfSmall(ratio) : std::atan2(ratio.above, ratio.below);
}

void turnBy(FootPoint& foot, double angle) {
  foot.phi += angle;
  if (std::abs(angle) < smallAngle) return turnBySmall<double>(foot, angle);
  const double c = std::cos(angle), s = std::sin(angle), cosine = foot.cosine;
  foot.cosine = cosine * c - foot.sine * s;
  foot.sine = cosine * s + foot.sine * c;
}

void look(FootPoint& foot, const ArcView& view, const ArcUnknowns& unknowns, const VisitReading& visit) {
  const auto residuals = lookFrom<double>(foot, view, unknowns.circle, visit.tanA, visit.tanE);
  foot.left = {angleOf(residuals.a), angleOf(residuals.e)};
  if (visit.slider)
    foot.sliderLeft =
        wrapped(Angle::fromRadians(*visit.slider - unknowns.sliderZero - view.turn * foot.phi)).radians();
}

FootPoint nearestInPlane(const ArcView& view, const Circle& circle, const VisitReading& visit) {
  FootPoint foot;
  turnTo<double>(foot, sightedPoint(view, visit), circle);
  foot.phi = std::atan2(foot.sine, foot.cosine);
  return foot;
}

}  // namespace

ArcView::ArcView(const Measurement& measurement, int axisDeg)
    : distance(measurement.distance),
      relation(measurement.relation),
      whitening{1 / measurement.sigmaHorizontal.radians(), 1 / measurement.sigmaVertical.radians(),
                1 / measurement.sigmaSlider.radians()},
      turn(halfTurnSign(axisDeg)) {}

PlanePoint<double> sightedPoint(const ArcView& view, const VisitReading& visit) {
  return sightedAlong(view, visit.tanA, visit.tanE);
}

FootPoint footPoint(const ArcView& view, const ArcUnknowns& unknowns, const VisitReading& visit,
                    FootPoint foot) {
  look(foot, view, unknowns, visit);
  const double radius = unknowns.circle.radius, sliderRows = visit.slider ? 1 : 0;
  double before = 0;
  for (int i = 0; i < mostFootSteps; ++i) {
    const Direction<double> along = alongArc<double>(view, radius, foot);
    const double step =
        boundedArcAngleStep(footStep<double>(view, radius, foot, along, visit.rows, sliderRows));
    turnBy(foot, step);
    if (isLastFootStep(std::abs(step), std::abs(before))) {
      followLastStep<double>(foot, view, along, step);
      foot.sliderLeft -= view.turn * step * sliderRows;
      return foot;
    }
    look(foot, view, unknowns, visit);
    before = step;
  }
  return foot;
}

FootPoint footPoint(const ArcView& view, const ArcUnknowns& unknowns, const VisitReading& visit) {
  return footPoint(view, unknowns, visit, nearestInPlane(view, unknowns.circle, visit));
}

}  // namespace alidade
