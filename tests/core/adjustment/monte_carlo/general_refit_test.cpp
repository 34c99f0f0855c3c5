#include "core/adjustment/monte_carlo/refit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/perfect_draw.h"

namespace alidade {
namespace {

// The refit stops within a millionth of σ, some 1e-7 mm.
constexpr double leftByTheRefit = 1e-6;  // mm

void expectCentres(const std::vector<double>& found, const std::array<Circle, 2>& circles) {
  ASSERT_EQ(found.size(), 4u);
  for (std::size_t arc = 0; arc < 2; ++arc) {
    EXPECT_NEAR(found[2 * arc], circles[arc].x, leftByTheRefit) << arc;
    EXPECT_NEAR(found[2 * arc + 1], circles[arc].y, leftByTheRefit) << arc;
  }
}

// Perfect readings, for any drawn circles, determine the minimum uniquely. With a known radius the circles
// have the drawn one.
TEST(GeneralRefit, FindsTheCirclesWhoseReadingsWereDrawn) {
  for (const RadiusModel radius : {RadiusModel::Free, RadiusModel::Common, RadiusModel::Known})
    for (const bool sliders : {false, true}) {
      SCOPED_TRACE(static_cast<int>(radius));
      Measurement measurement = test::uncertainMeasurement();
      measurement.radiusModel = radius;
      measurement =
          test::withPerfectArcs(measurement, {Circle{0.5, 1, 400}, Circle{0, -1, 400}}, 9, 150, sliders);
      Measurement wanted = measurement;
      wanted.distance += 1.1;
      wanted.nominalRadius = 400.2;
      const std::array<Circle, 2> circles{Circle{0.7, 1.4, 400.2},
                                          Circle{-0.2, -0.9, radius == RadiusModel::Free ? 399.7 : 400.2}};
      wanted = test::withPerfectArcs(wanted, circles, 9, 150.01, sliders);
      const test::FittedForDraws fitted(measurement);
      const RefitTask task = fitted.task();
      const auto refit = generalRefit(task);
      for (const double scale : {1.0, 2.5})
        expectCentres(test::centresOf(*refit, task, {test::drawOf(task, wanted, scale, 3)}), circles);
    }
}

// If the readings scatter, the refit has the minimum of a session with these readings typed.
TEST(GeneralRefit, IsTheFitOfTheSessionDrawn) {
  std::mt19937_64 generator(12);
  for (const RadiusModel radius : {RadiusModel::Free, RadiusModel::Common, RadiusModel::Known}) {
    Measurement measurement = test::uncertainMeasurement();
    measurement.radiusModel = radius;
    const std::array<Circle, 2> circles{Circle{0.5, 1, 400.3}, Circle{0, -1, 399.8}};
    measurement = test::withPerfectArcs(measurement, circles, 9, 150);
    Measurement wanted = measurement;
    wanted.nominalRadius = 400.2;
    for (ArcMeasurement& arc : wanted.arcs) test::addNoise(arc, measurement, generator);
    const JointFit expected = fitSession(wanted).joint;
    const test::FittedForDraws fitted(measurement);
    const RefitTask task = fitted.task();
    expectCentres(test::centresOf(*generalRefit(task), task, {test::drawOf(task, wanted, 0.7, 2)}),
                  {expected.circleOf(0), expected.circleOf(1)});
  }
}

TEST(GeneralRefit, DrawsWhatIsKnownOfEffectsBeforehand) {
  const std::array<Circle, 2> circles{Circle{0.6, 1.1, 400.1}, Circle{0.1, -1.2, 399.9}};
  const test::DrawnDrift drift({Circle{0.5, 1, 400}, Circle{0, -1, 400}}, circles, 4);
  const RefitTask task = drift.task();
  expectCentres(test::centresOf(*generalRefit(task), task, {drift.draw()}), circles);
}

// All readings of the arc at 180° are drawn at one place; the draws before and after are unaffected.
TEST(GeneralRefit, MissesTheArcThatFixesNoCircle) {
  const std::array<Circle, 2> circles{Circle{0.5, 1, 400}, Circle{0, -1, 400}};
  const Measurement measurement = test::withPerfectArcs(test::uncertainMeasurement(), circles, 9, 150);
  Measurement lost = measurement;
  for (Sighting& sighting : lost.arcs[1].sightings) {
    sighting.a = lost.arcs[1].sightings[0].a;
    sighting.e = lost.arcs[1].sightings[0].e;
  }
  const test::FittedForDraws fitted(measurement);
  const RefitTask task = fitted.task();
  const Draw quiet = test::quietDraw(task);
  const std::vector<double> found =
      test::centresOf(*generalRefit(task), task, {quiet, test::drawOf(task, lost, 1, 5), quiet});
  expectCentres({found.begin(), found.begin() + 4}, circles);
  expectCentres({found.begin() + 8, found.end()}, circles);
  EXPECT_NEAR(found[5], circles[0].y, leftByTheRefit);
  EXPECT_TRUE(std::isnan(found[6]) && std::isnan(found[7]));
}

}  // namespace
}  // namespace alidade
