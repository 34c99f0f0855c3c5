#include "core/adjustment/arc/first_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <variant>
#include <vector>

#include "tests/support/perfect_session.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

const Circle circleSighted{0.7, -1.1, 400.4};

/// Each row once in either face, with errors that cancel in their mean.
ArcMeasurement inBothFaces(const ArcMeasurement& arc, Angle horizontal, Angle vertical) {
  ArcMeasurement both = arc;
  both.sightings.clear();
  for (Sighting sighting : arc.sightings)
    for (const int face : {1, 2}) {
      const double side = face == 1 ? 1 : -1;
      Sighting& row = both.sightings.emplace_back(sighting);
      row.row = both.sightings.size() + 3;
      row.face = face;
      row.a = row.a + horizontal * side;
      row.e = row.e - vertical * side;
    }
  return both;
}

// The two readings of a visit have a perfect mean, so χ² is the sum of (d/σ)², where ±d is their deviation.
// Readings are rounded to some 1e-12 mm; the fast fit is accurate to 1e-9 mm.
TEST(FirstFit, SumsWhatTheFacesOfAVisitDifferBy) {
  Measurement measurement = test::usualMeasurement();
  measurement.sigmaVertical = Angle::fromArcseconds(5);
  for (const int places : {3, 9, 17}) {
    const ArcMeasurement single =
        test::perfectArc(measurement, circleSighted, test::spread(places, 160), 180);
    const ArcMeasurement both = inBothFaces(single, Angle::fromArcseconds(3), Angle::fromArcseconds(4));
    const auto fit = firstFit(measurement, both);
    ASSERT_TRUE(fit && fit->converged());
    EXPECT_NEAR(fit->circle.x, circleSighted.x, 1e-8);
    EXPECT_NEAR(fit->circle.y, circleSighted.y, 1e-8);
    EXPECT_NEAR(fit->circle.radius, circleSighted.radius, 1e-8);
    const double expected = 2 * places * (std::pow(3.0 / 2, 2) + std::pow(4.0 / 5, 2));
    EXPECT_NEAR(fit->chiSquare, expected, 1e-9 * expected);
    EXPECT_EQ(fit->degreesOfFreedom, 4 * places - places - 3);
    EXPECT_EQ(fit->position, 1u);
    EXPECT_EQ(fit->axisDeg, 180);
    ASSERT_EQ(fit->residuals.size(), both.sightings.size());
    for (std::size_t i = 0; i < both.sightings.size(); ++i)
      EXPECT_EQ(fit->residuals[i].row, both.sightings[i].row);
  }
}

// Many rounds sight the same places: with enough rounds the first, the middle and the last visit are at one
// place. Only the general fit fills `residuals`.
TEST(FirstFit, TakesTheFastFitHoweverOftenThePlacesComeAgain) {
  const Measurement measurement = test::usualMeasurement();
  const ArcMeasurement once = test::perfectArc(measurement, circleSighted, test::spread(5, 160), 0);
  for (const int rounds : {1, 2, 3, 4, 5, 11, 26}) {
    ArcMeasurement arc = once;
    arc.sightings.clear();
    for (int round = 1; round <= rounds; ++round)
      for (Sighting sighting : once.sightings) {
        sighting.round = round;
        sighting.row = arc.sightings.size();
        sighting.e = sighting.e + Angle::fromArcseconds(round % 3 - 1);
        arc.sightings.push_back(sighting);
      }
    const auto fit = firstFit(measurement, arc);
    ASSERT_TRUE(fit && fit->converged()) << rounds;
    EXPECT_EQ(fit->residualRms, 0) << rounds;
    EXPECT_NEAR(fit->circle.radius, circleSighted.radius, 0.05) << rounds;
  }
}

// Ray-traced sessions, with and without effects, in one face or two, and by either relation. The general fit
// stops within 1e-9 σ; cofactors are from a circle some micrometres away.
TEST(FirstFit, IsTheFitOfTheArc) {
  for (test::Trial& trial : test::trials())
    for (const auto relation : {VerticalAngleRelation::Exact, VerticalAngleRelation::Planar}) {
      SCOPED_TRACE(trial.id);
      trial.measurement.relation = relation;
      trial.measurement.sigmaHorizontal = Angle::fromArcseconds(1.5);
      for (const ArcMeasurement& arc : trial.measurement.arcs) {
        const auto first = firstFit(trial.measurement, arc), fit = fitArc(trial.measurement, arc);
        ASSERT_TRUE(first && fit);
        EXPECT_NEAR(first->circle.x, fit->circle.x, 1e-8);
        EXPECT_NEAR(first->circle.y, fit->circle.y, 1e-8);
        EXPECT_NEAR(first->circle.radius, fit->circle.radius, 1e-8);
        EXPECT_NEAR(first->chiSquare, fit->chiSquare, 1e-7 * fit->chiSquare);
        EXPECT_EQ(first->degreesOfFreedom, fit->degreesOfFreedom);
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j)
            EXPECT_NEAR(first->cofactor[i][j], fit->cofactor[i][j],
                        1e-4 * std::sqrt(fit->cofactor[i][i] * fit->cofactor[j][j]));
      }
    }
}

// The fast fit refuses readings beyond 45° from the line of sight.
TEST(FirstFit, TakesTheGeneralFitWhereTheFastOneIsRefused) {
  Measurement measurement = test::usualMeasurement();
  measurement.distance = 300;
  const ArcMeasurement arc = test::perfectArc(measurement, circleSighted, test::spread(9, 160));
  ASSERT_FALSE(fitVisitsFast(measurement, visitsOf(arc), ZeroLine(measurement, arc)));
  const auto fit = firstFit(measurement, arc);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->circle.y, circleSighted.y, 1e-9);
  EXPECT_NEAR(fit->circle.radius, circleSighted.radius, 1e-9);
  EXPECT_NEAR(fit->residuals.front().arcAngle, test::spread(9, 160).front(), 1e-9);
}

// The reason for the refusal is that of `fitArc`, which depends only on the stated noise.
TEST(FirstFit, RefusesWhatFixesNoCircle) {
  Measurement measurement = test::usualMeasurement();
  const auto faultOf = [&](const std::vector<double>& angles) {
    const auto fit = firstFit(measurement, test::perfectArc(measurement, circleSighted, angles));
    return fit ? ArcFault(arc_fault::RadiusUndetermined()) : fit.problem();
  };
  EXPECT_TRUE(std::holds_alternative<arc_fault::TooFewPlaces>(faultOf({1, 2})));
  EXPECT_TRUE(std::holds_alternative<arc_fault::PlacesRepeat>(faultOf({1, 1, 1, 2, 2, 2, 2})));
  EXPECT_TRUE(
      std::holds_alternative<arc_fault::PlacesRepeat>(faultOf({1, 1.0001, 1.00015, 0.9999, 2, 2.0001})));
  // Two places 0.11 mm apart, 4.8 σ of 2″, and a distant one, which would determine a circle.
  EXPECT_TRUE(std::holds_alternative<arc_fault::PlacesRepeat>(faultOf({1, 1.00028, 1 + std::numbers::pi})));
  // 2′ are 1.4 mm: the sagittas of these arcs, R (1 − cos span/2), are 0.9 mm and 3.4 mm.
  measurement.sigmaHorizontal = measurement.sigmaVertical = Angle::fromArcseconds(120);
  for (const double span : {8.0, 15.0})
    EXPECT_TRUE(std::holds_alternative<arc_fault::ArcTooShort>(faultOf(test::spread(4, span)))) << span;
}

// A visit with two rows has the weight of two visits with one row: doubling the first row moves the circle as
// three single rows at that place do.
TEST(FirstFit, WeighsVisitsByTheirRows) {
  const Measurement measurement = test::usualMeasurement();
  ArcMeasurement arc = test::perfectArc(measurement, circleSighted, test::spread(7, 160));
  std::mt19937_64 generator(9);
  test::addNoise(arc, measurement, generator);
  ArcMeasurement faces = arc, rounds = arc;
  Sighting again = arc.sightings.front();
  again.face = 2;
  faces.sightings.insert(faces.sightings.begin() + 1, again);
  again.face = 1;
  again.round = 2;
  rounds.sightings.push_back(again);
  const auto once = fitVisitsFast(measurement, visitsOf(arc), ZeroLine(measurement, arc)),
             twice = fitVisitsFast(measurement, visitsOf(faces), ZeroLine(measurement, faces)),
             apart = fitVisitsFast(measurement, visitsOf(rounds), ZeroLine(measurement, rounds));
  ASSERT_TRUE(once && twice && apart);
  EXPECT_NEAR(twice->circle.y, apart->circle.y, 1e-8);
  EXPECT_NEAR(twice->circle.radius, apart->circle.radius, 1e-8);
  EXPECT_GT(std::abs(twice->circle.y - once->circle.y), 1e-4);
}

}  // namespace
}  // namespace alidade
