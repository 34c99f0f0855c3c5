#include "core/adjustment/arc/foot_point.h"

#include <cmath>

#include "core/adjustment/numerics/arc_angle_step.h"
#include "core/observation/half_turn.h"

namespace alidade {

namespace {

/// The angle whose sine and cosine are as `above` to `below`; quick where it is as small as a residual.
double angleOf(double above, double below) {
  constexpr double small = 1e-3;  // the series is exact to rounding up to there
  if (!(std::abs(above) < small * below)) return std::atan2(above, below);
  const double t = above / below, tt = t * t;
  return t * (1 - tt * (1.0 / 3 - tt * (1.0 / 5)));
}

/// Turns the direction of the foot by a small angle.
void turnBy(FootPoint& foot, double angle) {
  constexpr double small = 1e-3;  // as above
  const double square = angle * angle;
  const bool isSmall = std::abs(angle) < small;
  const double c = isSmall ? 1 - square * (1.0 / 2 - square * (1.0 / 24)) : std::cos(angle);
  const double s = isSmall ? angle * (1 - square * (1.0 / 6 - square * (1.0 / 120))) : std::sin(angle);
  foot.phi += angle;
  const double cosine = foot.cosine;
  foot.cosine = cosine * c - foot.sine * s;
  foot.sine = cosine * s + foot.sine * c;
}

void look(FootPoint& foot, const ArcView& view, const ArcUnknowns& unknowns, const VisitReading& visit) {
  const double l = view.distance;
  const double x = unknowns.circle.x + unknowns.circle.radius * foot.cosine;
  const double y = unknowns.circle.y + unknowns.circle.radius * foot.sine;
  const double square = x * x + l * l;
  foot.left.a = angleOf(visit.tanA * l - x, l + x * visit.tanA);
  const double perSquare = 1 / square;
  foot.aX = l * perSquare;
  foot.aL = -x * perSquare;
  const bool isExact = view.relation == VerticalAngleRelation::Exact;
  const double ground = isExact ? std::sqrt(square) : l;
  const double slant = ground * ground + y * y;
  foot.left.e = angleOf(visit.tanE * ground - y, ground + y * visit.tanE);
  const double perBoth = 1 / (ground * slant);
  foot.eY = ground * ground * perBoth;
  const double perGround = -y * perBoth;
  foot.eX = isExact ? perGround * x : 0;
  foot.eL = perGround * l;
  if (visit.slider)
    foot.sliderLeft =
        wrapped(Angle::fromRadians(*visit.slider - unknowns.sliderZero - view.turn * foot.phi)).radians();
}

/// ∂(a, e)/∂φ, in σ.
Direction<double> alongArc(const ArcView& view, double radius, const FootPoint& foot) {
  return {-view.whitening.horizontal * radius * foot.sine * foot.aX,
          view.whitening.vertical * radius * (foot.cosine * foot.eY - foot.sine * foot.eX)};
}

/// By what the arc's bend adds to the `square` of ∂r/∂φ in the second derivative of |r|²/2, that of the
/// projection left out: steps then fall off faster. 0 where that is much, far from the arc.
double bend(const ArcView& view, double radius, const VisitReading& visit, const FootPoint& foot,
            double square) {
  const double h = view.whitening.horizontal, v = view.whitening.vertical;
  const double added = visit.rows * radius *
                       (h * h * foot.left.a * foot.cosine * foot.aX +
                        v * v * foot.left.e * (foot.sine * foot.eY + foot.cosine * foot.eX));
  return std::abs(added) < 0.1 * square ? added : 0;
}

}  // namespace

ArcView::ArcView(const Measurement& measurement, int axisDeg)
    : distance(measurement.distance),
      relation(measurement.relation),
      whitening{1 / measurement.sigmaHorizontal.radians(), 1 / measurement.sigmaVertical.radians(),
                1 / measurement.sigmaSlider.radians()},
      turn(halfTurnSign(axisDeg)) {}

PlanePoint<double> sightedPoint(const ArcView& view, const VisitReading& visit) {
  const double l = view.distance, x = l * visit.tanA;
  const double ground = view.relation == VerticalAngleRelation::Exact ? std::sqrt(x * x + l * l) : l;
  return {x, ground * visit.tanE};
}

FootPoint nearestInPlane(const ArcView& view, const Circle& circle, const VisitReading& visit) {
  const PlanePoint<double> sighted = sightedPoint(view, visit);
  const double x = sighted.x - circle.x, y = sighted.y - circle.y;
  const double length = std::sqrt(x * x + y * y);
  FootPoint foot;
  if (length > 0) {
    foot.phi = std::atan2(y, x);
    foot.cosine = x / length;
    foot.sine = y / length;
  }
  return foot;
}

FootPoint footPoint(const ArcView& view, const ArcUnknowns& unknowns, const VisitReading& visit,
                    FootPoint foot) {
  constexpr int maximumIterations = 25;
  constexpr double smallestStep = 1e-14;  // rad; 4e-12 mm on a 400 mm arc
  constexpr double near = 1e-10;          // only from here on a step tells how short the next will be

  look(foot, view, unknowns, visit);
  const double alongSlider = visit.slider ? view.turn * view.whitening.slider : 0;
  double before = 0;
  for (int i = 0; i < maximumIterations; ++i) {
    const Direction<double> along = alongArc(view, unknowns.circle.radius, foot);
    const double left = visit.rows * (along.a * view.whitening.horizontal * foot.left.a +
                                      along.e * view.whitening.vertical * foot.left.e) +
                        alongSlider * view.whitening.slider * foot.sliderLeft;
    const double square = visit.rows * (along.a * along.a + along.e * along.e) + alongSlider * alongSlider;
    const double step =
        boundedArcAngleStep(left / (square + bend(view, unknowns.circle.radius, visit, foot, square)));
    turnBy(foot, step);
    // Steps fall off by one ratio, that of residual to radius: is the next one little enough?
    const bool isNear = std::abs(step) < near && std::abs(step * step) < smallestStep * std::abs(before);
    if (isNear || std::abs(step) < smallestStep) {
      // The square of such a step is nothing, and the derivatives stay.
      foot.left.a -= along.a / view.whitening.horizontal * step;
      foot.left.e -= along.e / view.whitening.vertical * step;
      if (visit.slider) foot.sliderLeft -= view.turn * step;
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
