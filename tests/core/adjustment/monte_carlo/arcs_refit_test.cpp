#include "core/adjustment/monte_carlo/refit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/support/perfect_draw.h"

namespace alidade {
namespace {

constexpr std::array circlesApart{Circle{0.5, 1, 400}, Circle{0, -1, 400}};

// Either refit stops within a millionth of σ, some 1e-7 mm.
constexpr double leftByEither = 1e-6;  // mm

/// Adds a second row at each place, in face 2. The differences of the faces cancel in their mean.
Measurement inBothFaces(Measurement measurement, Angle difference) {
  for (ArcMeasurement& arc : measurement.arcs) {
    std::vector<Sighting> rows;
    for (Sighting row : arc.sightings) {
      const Sighting read = row;
      row.a = read.a + difference;
      row.e = read.e - difference;
      rows.push_back(row);
      row.face = 2;
      row.a = read.a - difference;
      row.e = read.e + difference;
      rows.push_back(row);
    }
    arc.sightings = rows;
  }
  return measurement;
}

bool serves(const Measurement& measurement) {
  const test::FittedForDraws fitted(measurement);
  return arcsRefit(fitted.task()) != nullptr;
}

TEST(ArcsRefit, ServesArcsThatHaveNothingInCommon) {
  const Measurement measurement = test::withPerfectArcs(test::uncertainMeasurement(), circlesApart, 9, 150);
  EXPECT_TRUE(serves(measurement));
  Measurement bothFaces = inBothFaces(measurement, Angle());
  EXPECT_TRUE(serves(bothFaces));
  bothFaces.arcs[1].sightings.pop_back();
  EXPECT_FALSE(serves(bothFaces)) << "visits of one row and of two";
  Measurement sliderAtOnePlace = measurement;
  sliderAtOnePlace.arcs[1].sightings[5].slider = Angle();
  EXPECT_FALSE(serves(sliderAtOnePlace));
  for (const RadiusModel radius : {RadiusModel::Common, RadiusModel::Known}) {
    Measurement shared = measurement;
    shared.radiusModel = radius;
    EXPECT_FALSE(serves(shared));
  }
  Measurement effect = measurement;
  effect.effects = {"gravity_sag"};
  EXPECT_FALSE(serves(effect));
  effect.effects = {"of no catalogue"};
  EXPECT_TRUE(serves(effect));
}

// Perfect readings determine the minimum uniquely, and proportional arcs have proportional centres: L is
// drawn too. Some numbers of draws do not fill all lanes.
TEST(ArcsRefit, FindsTheCirclesWhoseReadingsWereDrawn) {
  const Measurement measurement = test::withPerfectArcs(test::uncertainMeasurement(), circlesApart, 9, 150);
  for (const bool faces : {false, true})
    for (const int count : {1, 4, 11}) {
      const test::FittedForDraws fitted(faces ? inBothFaces(measurement, Angle()) : measurement);
      const RefitTask task = fitted.task();
      std::vector<std::array<Circle, 2>> circles;
      std::vector<Draw> drawn;
      for (int i = 0; i < count; ++i) {
        circles.push_back({Circle{0.5 + 0.1 * i, 1.2, 400.1 - 0.2 * i}, Circle{-0.1, -1 - 0.1 * i, 399.9}});
        Measurement wanted = measurement;
        wanted.distance += 0.3 * (i - 1);
        wanted = test::withPerfectArcs(wanted, circles.back(), 9, 150 + 0.01 * i);
        if (faces) wanted = inBothFaces(wanted, Angle::fromArcseconds(3));
        drawn.push_back(test::drawOf(task, wanted, 0.5 + 0.3 * i, 6));
      }
      const std::vector<double> found = test::centresOf(*arcsRefit(task), task, drawn);
      for (std::size_t i = 0; i < drawn.size(); ++i)
        for (std::size_t arc = 0; arc < 2; ++arc) {
          EXPECT_NEAR(found[4 * i + 2 * arc], circles[i][arc].x, leftByEither) << i;
          EXPECT_NEAR(found[4 * i + 2 * arc + 1], circles[i][arc].y, leftByEither) << i;
        }
    }
}

// The fast fit refuses a reading off by 10′, and the general fit takes its place. An arc at a single place,
// or 2° long, has no result in either. The other draws are unaffected.
TEST(ArcsRefit, LeavesToTheGeneralOneWhatTheFastFitRefuses) {
  const Measurement measurement = test::withPerfectArcs(test::uncertainMeasurement(), circlesApart, 9, 150);
  const test::FittedForDraws fitted(measurement);
  const RefitTask task = fitted.task();
  Measurement off = measurement, lost = measurement, tooShort = measurement;
  off.arcs[0].sightings[3].e = off.arcs[0].sightings[3].e + Angle::fromArcseconds(600);
  for (Sighting& sighting : lost.arcs[1].sightings) {
    sighting.a = lost.arcs[1].sightings[0].a;
    sighting.e = lost.arcs[1].sightings[0].e;
  }
  tooShort.arcs[1] = test::withPerfectArcs(measurement, circlesApart, 9, 2).arcs[1];
  const std::vector<Draw> drawn{test::quietDraw(task), test::drawOf(task, off, 1, 7),
                                test::drawOf(task, lost, 1, 8), test::drawOf(task, tooShort, 1, 9),
                                test::quietDraw(task)};
  const std::vector<double> found = test::centresOf(*arcsRefit(task), task, drawn),
                            expected = test::centresOf(*generalRefit(task), task, drawn);
  EXPECT_GT(std::abs(expected[5] - circlesApart[0].y), 0.1);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool isOfArcLost = i == 10 || i == 11 || i == 14 || i == 15;
    EXPECT_EQ(std::isnan(found[i]), isOfArcLost) << i;
    if (isOfArcLost) continue;
    EXPECT_NEAR(found[i], expected[i], leftByEither) << i;
  }
}

}  // namespace
}  // namespace alidade
