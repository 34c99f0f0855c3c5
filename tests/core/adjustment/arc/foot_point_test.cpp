#include "core/adjustment/arc/foot_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace alidade {
namespace {

// The paper's arc, sighted 40″ off to the right and 30″ too high near its left end, with unequal σ.
const Circle circle{-0.8, 1.0, 402};
constexpr double distance = 2405;
const Angle sigmaHorizontal = Angle::fromArcseconds(2), sigmaVertical = Angle::fromArcseconds(3);

ArcView viewOf(VerticalAngleRelation relation, int axisDeg = 0) {
  Measurement measurement;
  measurement.distance = distance;
  measurement.relation = relation;
  measurement.sigmaHorizontal = sigmaHorizontal;
  measurement.sigmaVertical = sigmaVertical;
  measurement.sigmaSlider = Angle::fromArcseconds(10);
  return ArcView(measurement, axisDeg);
}

Direction<double> sighted(VerticalAngleRelation relation) {
  Direction<double> direction =
      observe(targetOnArc(circle.x, circle.y, circle.radius, 2.6), distance, relation);
  direction.a += Angle::fromArcseconds(40).radians();
  direction.e += Angle::fromArcseconds(30).radians();
  return direction;
}

double costAt(double phi, VerticalAngleRelation relation) {
  const auto model = observe(targetOnArc(circle.x, circle.y, circle.radius, phi), distance, relation);
  const auto s = sighted(relation);
  return std::hypot((s.a - model.a) / sigmaHorizontal.radians(), (s.e - model.e) / sigmaVertical.radians());
}

class FootPointTest : public testing::TestWithParam<VerticalAngleRelation> {};

FootPoint footOn(const Circle& on, VerticalAngleRelation relation) {
  return footPoint(viewOf(relation), {on}, VisitReading(sighted(relation)));
}

TEST_P(FootPointTest, IsTheNearestPointInUnitsOfSigma) {
  const FootPoint foot = footOn(circle, GetParam());
  const double nearest = costAt(foot.phi, GetParam());
  EXPECT_NEAR(std::hypot(foot.left.a / sigmaHorizontal.radians(), foot.left.e / sigmaVertical.radians()),
              nearest, 1e-9 * nearest);
  for (const double away : {-1e-3, -1e-5, 1e-5, 1e-3})
    EXPECT_GT(costAt(foot.phi + away, GetParam()), nearest) << away;
}

// The iteration from another start on the arc ends at the same point, to rounding of its angle.
TEST_P(FootPointTest, IsFoundFromAFar) {
  const FootPoint foot = footOn(circle, GetParam());
  for (const double away : {-0.5, -1e-3, 0.2}) {
    FootPoint start;
    start.phi = foot.phi + away;
    start.cosine = std::cos(start.phi);
    start.sine = std::sin(start.phi);
    const FootPoint again = footPoint(viewOf(GetParam()), {circle}, VisitReading(sighted(GetParam())), start);
    EXPECT_NEAR(again.phi, foot.phi, 1e-13);
    EXPECT_NEAR(again.sine, std::sin(foot.phi), 1e-13);
    EXPECT_NEAR(again.left.a, foot.left.a, 1e-14);
  }
}

// A point typed a degree off is a tenth of the radius from the arc, and each step is a tenth of the one
// before: only the last ones are short enough.
TEST_P(FootPointTest, IsFoundToRoundingFarFromTheArcToo) {
  Direction<double> off = sighted(GetParam());
  off.a -= Angle::fromDegrees(1).radians();
  const VisitReading visit(off);
  FootPoint converged = footPoint(viewOf(GetParam()), {circle}, visit);
  for (int again = 0; again < 20; ++again)
    converged = footPoint(viewOf(GetParam()), {circle}, visit, converged);
  for (const double away : {-0.5, -0.1, -1e-3, -1e-4, 1e-5, 0.02, 0.2}) {
    FootPoint start;
    start.phi = converged.phi + away;
    start.cosine = std::cos(start.phi);
    start.sine = std::sin(start.phi);
    EXPECT_NEAR(footPoint(viewOf(GetParam()), {circle}, visit, start).phi, converged.phi, 1e-13) << away;
  }
}

// The slider reading is off by 30″ in either direction, and the visit has two rows. No place near the foot
// may fit better than the foot.
TEST_P(FootPointTest, WeighsTheSliderAlong) {
  for (const int axisDeg : {0, 180}) {
    const ArcView view = viewOf(GetParam(), axisDeg);
    constexpr double zero = 0.3;
    VisitReading visit(sighted(GetParam()), 2);
    visit.slider = zero + view.turn * (2.6 + Angle::fromArcseconds(30).radians());
    const FootPoint foot = footPoint(view, {circle, zero}, visit);
    const auto cost = [&](double phi) {
      const double slider = (*visit.slider - zero - view.turn * phi) * view.whitening.slider;
      return std::hypot(std::sqrt(2) * costAt(phi, GetParam()), slider);
    };
    for (const double away : {-1e-5, 1e-5}) EXPECT_GT(cost(foot.phi + away), cost(foot.phi)) << away;
    EXPECT_NEAR(foot.sliderLeft, *visit.slider - zero - view.turn * foot.phi, 1e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(Relations, FootPointTest,
                         testing::Values(VerticalAngleRelation::Exact, VerticalAngleRelation::Planar));

}  // namespace
}  // namespace alidade
