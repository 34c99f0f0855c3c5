#include "core/adjustment/arc/visit_feet.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace alidade {
namespace {

const Circle trueCircle{-0.8, 1.0, 402};
constexpr double planeDistance = 2405, trueSliderZero = 0.3;

struct Situation {
  VerticalAngleRelation relation = VerticalAngleRelation::Exact;
  int axisDeg = 0;
  bool hasSlider = false;
};

ArcView viewIn(const Situation& situation) {
  Measurement measurement;
  measurement.distance = planeDistance;
  measurement.relation = situation.relation;
  measurement.sigmaHorizontal = Angle::fromArcseconds(2);
  measurement.sigmaVertical = Angle::fromArcseconds(3);
  measurement.sigmaSlider = Angle::fromArcseconds(10);
  return ArcView(measurement, situation.axisDeg);
}

/// Visits of one or two rows along 5 rad of the arc; every third visit has no slider reading. Each circle and
/// slider reading is off by at most `off`.
std::vector<VisitReading> visitsAlong(const Situation& situation, std::size_t count, Angle off) {
  std::mt19937 random(static_cast<unsigned>(count));
  std::uniform_real_distribution<double> within(-off.radians(), off.radians());
  std::vector<VisitReading> visits;
  for (std::size_t i = 0; i < count; ++i) {
    const double phi = -2.5 + 5 * static_cast<double>(i) / static_cast<double>(count);
    Direction<double> seen = observe(targetOnArc(trueCircle.x, trueCircle.y, trueCircle.radius, phi),
                                     planeDistance, situation.relation);
    seen.a += within(random);
    seen.e += within(random);
    VisitReading& visit = visits.emplace_back(seen, i % 2 == 0 ? 1 : 2);
    if (situation.hasSlider && i % 3 != 2)
      visit.slider = trueSliderZero + viewIn(situation).turn * phi + within(random);
  }
  return visits;
}

VisitFeet feetOf(const Situation& situation, const std::vector<VisitReading>& visits) {
  VisitFeet feet(viewIn(situation));
  feet.reserve(visits.size());
  for (const VisitReading& visit : visits) feet.add(visit);
  return feet;
}

/// Order: x, y, R and the slider's zero.
ArcUnknowns moved(const Eigen::Vector4d& by) {
  return {{trueCircle.x + by[0], trueCircle.y + by[1], trueCircle.radius + by[2]}, trueSliderZero + by[3]};
}

double chiSquareAt(const Situation& situation, const std::vector<VisitReading>& visits,
                   const Eigen::Vector4d& by) {
  return feetOf(situation, visits).converge(moved(by), VisitFeet::From::Plane).chiSquare;
}

class VisitFeetTest : public testing::TestWithParam<Situation> {};

// Processing visits eight at a time or one by one gives the same equations; only the feet differ, within
// rounding of their angles. A block with a visit above 0.001 rad (206″) is processed one by one. At 2°, a
// fifth of the radius from the arc, a foot depends on its start by some 1e-11 rad.
TEST_P(VisitFeetTest, AreTheFootPointsOfEachVisit) {
  for (const std::size_t count : {1, 2, 7, 8, 9, 17, 24, 40})
    for (const double arcseconds : {0.0, 2.0, 100.0, 400.0, 7200.0}) {
      const auto visits = visitsAlong(GetParam(), count, Angle::fromArcseconds(arcseconds));
      VisitFeet feet = feetOf(GetParam(), visits);
      const double rounding = arcseconds > 1000 ? 1e-10 : 2e-13;
      const auto expectFeet = [&](const ArcUnknowns& unknowns, const char* from) {
        double chiSquare = 0;
        for (std::size_t v = 0; v < count; ++v) {
          const FootPoint foot = footPoint(viewIn(GetParam()), unknowns, visits[v]);
          const Whitening& w = viewIn(GetParam()).whitening;
          const auto place = [&] {
            return testing::Message() << from << ", visit " << v << " of " << count << ", " << arcseconds;
          };
          EXPECT_NEAR(std::remainder(feet.arcAngle(v) - foot.phi, 2 * std::numbers::pi), 0, rounding)
              << place();
          EXPECT_NEAR(feet.left(v).a, foot.left.a, rounding / 5) << place();
          EXPECT_NEAR(feet.left(v).e, foot.left.e, rounding / 5) << place();
          const double sliderLeft = visits[v].slider ? feet.sliderLeft(v) : 0;
          EXPECT_NEAR(sliderLeft, foot.sliderLeft, rounding) << place();
          chiSquare += visits[v].rows *
                           (std::pow(w.horizontal * foot.left.a, 2) + std::pow(w.vertical * foot.left.e, 2)) +
                       std::pow(w.slider * foot.sliderLeft, 2);
          EXPECT_EQ(feet.reading(v).tanA, visits[v].tanA);
          EXPECT_EQ(feet.reading(v).slider, visits[v].slider);
        }
        return chiSquare;
      };
      const auto converge = [&](const ArcUnknowns& unknowns, VisitFeet::From from, const char* said) {
        const ArcEquations equations = feet.converge(unknowns, from);
        const double chiSquare = expectFeet(unknowns, said);
        EXPECT_NEAR(equations.chiSquare, chiSquare, 1e-9 * (1 + chiSquare)) << said << count;
      };
      converge(moved({0, 0, 0, 0}), VisitFeet::From::Plane, "from the plane");
      converge(moved({0.01, -0.02, 0.03, 1e-5}), VisitFeet::From::Before, "from beside it");
      converge(moved({-3, 5, 8, 0.1}), VisitFeet::From::Before, "from afar");
      converge(moved({0, 0, 0, 6}), VisitFeet::From::Before, "with the slider round the circle");
    }
}

// With circle readings alone a visit leaves one condition, its distance d from the arc in σ. So χ² = d², and
// with g = −∂d/∂(x, y, R) the equations are g gᵀ and g d. The gradient is some 40 σ/mm; central differences
// over 1 µm err by 1e-8 σ/mm from rounding (1e-16 rad compared with 2″) and less from curvature.
TEST_P(VisitFeetTest, GradientMeetsTheChangeOfTheDistance) {
  Situation situation = GetParam();
  situation.hasSlider = false;
  Direction<double> seen = observe(targetOnArc(trueCircle.x, trueCircle.y, trueCircle.radius, 2.6),
                                   planeDistance, situation.relation);
  seen.a += Angle::fromArcseconds(40).radians();
  seen.e += Angle::fromArcseconds(30).radians();
  const std::vector<VisitReading> visit{VisitReading(seen)};
  const auto distanceFor = [&](const Eigen::Vector4d& by) {
    return std::sqrt(chiSquareAt(situation, visit, by));
  };
  const ArcEquations equations =
      feetOf(situation, visit).converge(moved({0, 0, 0, 0}), VisitFeet::From::Plane);
  const double fromArc = distanceFor({0, 0, 0, 0});
  constexpr double h = 1e-3, tolerance = 1e-6;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector4d by = h * Eigen::Vector4d::Unit(i);
    EXPECT_NEAR((distanceFor(-by) - distanceFor(by)) / (2 * h), equations.rightSide[i] / fromArc, tolerance);
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(equations.normal[i][j],
                  equations.rightSide[i] * equations.rightSide[j] / equations.chiSquare,
                  1e-12 * std::sqrt(equations.normal[i][i] * equations.normal[j][j]));
  }
}

// −½ ∂χ²/∂u by central differences, with new feet each time: over 1 µm and 1e-7 rad they err by 1e-6 of some
// 100/mm and 1e7/rad from curvature and rounding.
TEST_P(VisitFeetTest, RightSideIsTheGradientOfTheMisfit) {
  const auto visits = visitsAlong(GetParam(), 17, Angle::fromArcseconds(20));
  const ArcEquations equations =
      feetOf(GetParam(), visits).converge(moved({0, 0, 0, 0}), VisitFeet::From::Plane);
  const Eigen::Vector4d steps(1e-3, 1e-3, 1e-3, 1e-7);
  for (int i = 0; i < (GetParam().hasSlider ? 4 : 3); ++i) {
    const Eigen::Vector4d by = steps[i] * Eigen::Vector4d::Unit(i);
    const double slope =
        (chiSquareAt(GetParam(), visits, by) - chiSquareAt(GetParam(), visits, -by)) / (2 * steps[i]);
    const double scale = std::sqrt(equations.normal[i][i]);
    EXPECT_NEAR(equations.rightSide[i] / scale, -slope / 2 / scale, 2e-5) << i;
  }
}

// Without residuals χ² of circles near the true one is δᵀNδ, up to third order: for 1 µm or 1e-6 rad, 1e-5 of
// it.
TEST_P(VisitFeetTest, NormalMatrixIsTheCurvatureOfTheMisfit) {
  const auto visits = visitsAlong(GetParam(), 17, {});
  const ArcEquations equations =
      feetOf(GetParam(), visits).converge(moved({0, 0, 0, 0}), VisitFeet::From::Plane);
  const Eigen::Vector4d steps(1e-3, 1e-3, 1e-3, 1e-6);
  const int unknowns = GetParam().hasSlider ? 4 : 3;
  for (int i = 0; i < unknowns; ++i)
    for (int j = 0; j < unknowns; ++j) {
      const Eigen::Vector4d one = steps[i] * Eigen::Vector4d::Unit(i),
                            other = steps[j] * Eigen::Vector4d::Unit(j);
      const double mixed =
          (chiSquareAt(GetParam(), visits, one + other) - chiSquareAt(GetParam(), visits, one - other)) /
          (4 * steps[i] * steps[j]);
      const double scale = std::sqrt(equations.normal[i][i] * equations.normal[j][j]);
      EXPECT_NEAR(equations.normal[i][j] / scale, mixed / scale, 1e-4) << i << ' ' << j;
      EXPECT_EQ(equations.normal[i][j], equations.normal[j][i]);
    }
}

// The sum of the redundancies is the number of readings minus that of the unknowns, including arc angles.
TEST_P(VisitFeetTest, RedundanciesAddUpToTheDegreesOfFreedom) {
  for (const std::size_t count : {5, 8, 17, 30}) {
    const auto visits = visitsAlong(GetParam(), count, Angle::fromArcseconds(2));
    VisitFeet feet = feetOf(GetParam(), visits);
    ArcEquations equations = feet.converge(moved({0, 0, 0, 0}), VisitFeet::From::Plane);
    if (!GetParam().hasSlider) equations.normal[3][3] = 1;
    Eigen::Matrix4d normal;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) normal(i, j) = equations.normal[i][j];
    const Eigen::Vector4d scale = normal.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::Matrix4d inverse = (scale.asDiagonal() * normal * scale.asDiagonal()).inverse();
    VisitFeet::Cofactor cofactor;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) cofactor[i][j] = scale[i] * inverse(i, j) * scale[j];
    double redundancy = 0, readings = 0;
    for (std::size_t v = 0; v < count; ++v) {
      const VisitReliability own = feet.reliabilityOf(v / eight, cofactor, {})[v % eight];
      redundancy += visits[v].rows * (own.redundancy[0] + own.redundancy[1]);
      readings += 2 * visits[v].rows;
      if (!visits[v].slider) continue;
      redundancy += own.redundancy[2];
      ++readings;
    }
    const double unknowns = static_cast<double>(count) + (GetParam().hasSlider ? 4 : 3);
    EXPECT_NEAR(redundancy, readings - unknowns, 1e-7 * readings) << count;
  }
}

INSTANTIATE_TEST_SUITE_P(Situations, VisitFeetTest,
                         testing::Values(Situation{}, Situation{.relation = VerticalAngleRelation::Planar},
                                         Situation{.hasSlider = true},
                                         Situation{VerticalAngleRelation::Planar, 180, true},
                                         Situation{.axisDeg = 180, .hasSlider = true}));

}  // namespace
}  // namespace alidade
