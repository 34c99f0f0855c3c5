#include "core/adjustment/monte_carlo/refit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/support/perfect_draw.h"

namespace alidade {
namespace {

constexpr std::array circlesRead{Circle{0.5, 1, 400}, Circle{0, -1, 400}};

/// The largest distance of a draw's refit from the centres of its circles, in σ of the session.
double missed(const RefitTask& task, const std::vector<Draw>& drawn,
              const std::vector<std::array<Circle, 2>>& circles) {
  const std::vector<double> found = test::centresOf(*expandedRefit(task, expandedModel(task)), task, drawn);
  double most = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    for (std::size_t arc = 0; arc < 2; ++arc) {
      const Circle& circle = circles[i][arc];
      const ArcSigma& sigma = task.fit.sigmas[arc];
      most = std::max({most, std::abs(found[4 * i + 2 * arc] - circle.x) / sigma.x,
                       std::abs(found[4 * i + 2 * arc + 1] - circle.y) / sigma.y});
    }
  return most;
}

// Perfect readings determine the minimum uniquely. Changes of a few σ on a usual arc leave at most 1e-5 σ of
// third order. The draws fill the lanes once and then partly.
TEST(ExpandedRefit, FindsTheCirclesWhoseReadingsWereDrawn) {
  for (const RadiusModel radius : {RadiusModel::Free, RadiusModel::Common, RadiusModel::Known})
    for (const bool sliders : {false, true}) {
      SCOPED_TRACE(static_cast<int>(radius));
      Measurement measurement = test::uncertainMeasurement();
      measurement.radiusModel = radius;
      measurement = test::withPerfectArcs(measurement, circlesRead, 9, 150, sliders);
      const test::FittedForDraws fitted(measurement);
      const RefitTask task = fitted.task();
      std::vector<std::array<Circle, 2>> circles;
      std::vector<Draw> drawn;
      for (int i = 0; i < 11; ++i) {
        const double by = 0.01 * (i - 5);
        Measurement wanted = measurement;
        wanted.distance += 7 * by;
        wanted.nominalRadius += 4 * by;
        circles.push_back({Circle{0.5 + by, 1.01 + by, 400 + 4 * by}, Circle{-by, -1 + by, 400 + 4 * by}});
        if (radius == RadiusModel::Free) circles.back()[1].radius = 400 - by;
        wanted = test::withPerfectArcs(wanted, circles.back(), 9, 150.001, sliders);
        drawn.push_back(test::drawOf(task, wanted, 0.4 + 0.2 * i, 3));
      }
      EXPECT_LT(missed(task, drawn, circles), 5e-5);
    }
}

// With three arcs, two of them about a common centre, and estimated zeros the result is that of the fits
// themselves. The drawn zeros and readings move a centre by some σ; a thousandth is of third order.
TEST(ExpandedRefit, AgreesWithTheGeneralOneOnPositionsMeasuredAgain) {
  for (const bool sliders : {false, true}) {
    Measurement measurement =
        test::withPerfectArcs(test::uncertainMeasurement(), circlesRead, 9, 150, sliders);
    measurement.arcs.push_back(measurement.arcs[0]);
    measurement.arcs.back().repeat = 2;
    measurement.arcs.back().position = 2;
    for (Sighting& sighting : measurement.arcs.back().sightings) sighting.sequence = measurement.rows++;
    setMoments(measurement);
    measurement.effects = {"vertical_drift"};
    const test::FittedForDraws fitted(measurement);
    const RefitTask task = fitted.task();
    std::vector<Draw> drawn(24);
    for (std::size_t i = 0; i < drawn.size(); ++i) task.plan.drawInto(drawn[i], 5, i);
    const std::vector<double> quick = test::centresOf(*expandedRefit(task, expandedModel(task)), task, drawn),
                              general = test::centresOf(*generalRefit(task), task, drawn);
    ASSERT_EQ(quick.size(), 6 * drawn.size());
    double moved = 0;
    for (std::size_t i = 0; i < quick.size(); ++i) {
      const ArcSigma& sigma = task.fit.sigmas[i % 6 / 2];
      EXPECT_NEAR(quick[i], general[i], 1e-3 * (i % 2 == 0 ? sigma.x : sigma.y));
      moved = std::max(moved, std::abs(general[i] - (i % 2 == 0 ? task.fit.arcs[i % 6 / 2].circle.x
                                                                : task.fit.arcs[i % 6 / 2].circle.y)) /
                                  (i % 2 == 0 ? sigma.x : sigma.y));
    }
    EXPECT_GT(moved, 1) << "something was drawn";
  }
}

// Targets that move along the arc, by 3.5 mm at its ends, depart from its tangents by up to 0.015 mm. With
// readings of 1′ the linear budget's Δd is off by a thirtieth of σ. The remainder is of third order, below
// the thousandth of σ that `propagateDistributions` requires.
TEST(ExpandedRefit, IsGoodToSecondOrder) {
  Measurement measurement = test::uncertainMeasurement();
  measurement.sigmaHorizontal = measurement.sigmaVertical = Angle::fromArcseconds(60);
  measurement = test::withPerfectArcs(measurement, circlesRead, 9, 90);
  const test::FittedForDraws fitted(measurement);
  const RefitTask task = fitted.task();
  for (const double sigmas : {-1.0, 1.0}) {
    const double by = sigmas * task.fit.sigmas[0].y;
    const std::array<Circle, 2> circles{Circle{0.5 + by, 1 + by, 400 - by}, Circle{-by, -1 + by, 400 + by}};
    const Measurement wanted = test::withPerfectArcs(measurement, circles, 9, 90 + sigmas);
    double linear = 0;  // change of Δd in the linear budget; the true Δd does not change
    for (const AdjustedReading& reading : task.fit.joint.readings) {
      const Sighting &from = measurement.arcs[reading.arc].sightings[reading.sighting],
                     &to = wanted.arcs[reading.arc].sightings[reading.sighting];
      const bool isHorizontal = reading.kind == ReadingKind::Horizontal;
      linear += reading.perReading * (isHorizontal ? to.a - from.a : to.e - from.e).radians();
    }
    EXPECT_GT(std::abs(linear), 0.03 * task.fit.intersection->sigma);
    EXPECT_LT(missed(task, {test::drawOf(task, wanted, 1, 3)}, {circles}), 1e-3);
  }
}

TEST(ExpandedRefit, DrawsWhatIsKnownOfEffectsBeforehand) {
  const std::array<Circle, 2> circles{Circle{0.55, 1.02, 400.03}, Circle{0.03, -1.04, 399.97}};
  const test::DrawnDrift drift(circlesRead, circles, 4);
  EXPECT_LT(missed(drift.task(), {drift.draw()}, {circles}), 1e-5);
}

TEST(ExpandedRefit, HasNoModelThatWouldFillTheMemory) {
  const test::FittedForDraws fitted(test::withPerfectArcs(test::uncertainMeasurement(), circlesRead, 9, 150));
  EXPECT_TRUE(expandedModel(fitted.task()));
  SessionFit many = fitted.task().fit;
  many.joint.readings.resize(1'000'000);
  EXPECT_FALSE(expandedModel({fitted.task().fitted, many, fitted.task().plan}));
}

}  // namespace
}  // namespace alidade
