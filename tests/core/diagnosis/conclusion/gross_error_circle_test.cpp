#include "core/diagnosis/conclusion/gross_error_circle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/diagnosis/search/inquiry.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

using enum ReadingKind;

struct Misread {
  std::size_t arc = 0, sighting = 0;
  ReadingKind kind = Horizontal;
  double arcseconds = 0;
};

Measurement misreadMeasurement(const std::vector<Misread>& errors, double step = 10) {
  Measurement measurement = test::usualMeasurement();
  std::mt19937_64 generator(11);
  for (const int axisDeg : {0, 180}) {
    measurement.arcs.push_back(test::perfectArc(measurement, {0.2, axisDeg == 0 ? 0.8 : -0.8, 400},
                                                test::spread(17, 16 * step, axisDeg == 0 ? 90 : -90),
                                                axisDeg));
    test::addNoise(measurement.arcs.back(), measurement, generator);
    for (Sighting& sighting : measurement.arcs.back().sightings) {
      sighting.row = 2 * sighting.row + 1;  // every other row is excluded
      sighting.sequence = measurement.rows++;
    }
  }
  setMoments(measurement);
  for (const Misread& error : errors) {
    Sighting& sighting = measurement.arcs[error.arc].sightings[error.sighting];
    const Angle off = Angle::fromArcseconds(error.arcseconds);
    if (error.kind == Horizontal) sighting.a = sighting.a + off;
    if (error.kind == Vertical) sighting.e = sighting.e + off;
  }
  return measurement;
}

/// Blamed readings are excluded from the fit, as in the diagnosis.
std::vector<ReadingDeviation> judged(const Measurement& measurement, const std::vector<Misread>& blamed) {
  GapModel model = *modelOf(measurement);
  std::vector<ReadingDeviation> deviations;
  for (const Misread& error : blamed) {
    const ReadingRef ref{error.arc, error.sighting, error.kind};
    model.options.without.push_back(ref);
    deviations.push_back(deviationAt(*model.measurement, ref, error.arcseconds));
  }
  model.refit();
  return withLikelierCircles(model, deviations);
}

// Places 10° apart, 20° to 70° from the top, where each circle determines the place. A wrong place deviates
// by a degree or more. Noise of 2″ in the retained circle predicts the other to 2″/tan 20°, plus its own 2″;
// four σ of both are 25″.
TEST(GrossErrorCircle, IsTheOneThatPutsTheSliderAmongItsNeighbours) {
  for (const std::size_t sighting : {2u, 4u, 6u, 11u, 13u})
    for (const std::size_t arc : {0u, 1u})
      for (const ReadingKind truly : {Horizontal, Vertical})
        for (const ReadingKind blamed : {Horizontal, Vertical}) {
          const double size = (sighting + arc) % 2 == 0 ? 900 : -900;
          const Measurement measurement = misreadMeasurement({{arc, sighting, truly, size}});
          const std::vector<ReadingDeviation> found = judged(measurement, {{arc, sighting, blamed, 500}});
          ASSERT_EQ(found.size(), 1u);
          EXPECT_EQ(found[0].kind, truly) << arc << ' ' << sighting << " blamed " << nameOf(blamed);
          EXPECT_NEAR(found[0].size, size, 25) << arc << ' ' << sighting << " blamed " << nameOf(blamed);
          EXPECT_EQ(found[0].row, 2 * sighting + 1);
          EXPECT_EQ(found[0].axisDeg, arc == 0 ? 0 : 180);
        }
}

TEST(GrossErrorCircle, IsFoundForEachOfSeveral) {
  const std::vector<Misread> errors{
      {1, 3, Vertical, 700}, {0, 12, Horizontal, -800}, {0, 3, Horizontal, 900}};
  std::vector<Misread> blamed = errors;
  blamed[0].kind = Horizontal;
  blamed[2].kind = Vertical;
  const std::vector<ReadingDeviation> found = judged(misreadMeasurement(errors), blamed);
  ASSERT_EQ(found.size(), errors.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    EXPECT_EQ(found[i].kind, errors[i].kind) << i;
    EXPECT_NEAR(found[i].size, errors[i].arcseconds, 25) << i;
    EXPECT_EQ(found[i].point, static_cast<int>(errors[i].sighting) + 1) << i;
  }
}

void expectUntouched(const Measurement& measurement, const Misread& blamed) {
  const std::vector<ReadingDeviation> found = judged(measurement, {blamed});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, blamed.kind);
  EXPECT_EQ(found[0].size, blamed.arcseconds);
}

// A slider reading or the other face already identifies the circle, so the named circle stays, even if it is
// wrong. An error of the slider is not an error of a circle.
TEST(GrossErrorCircle, StaysWhereMoreThanOneReadingTellsThePlace) {
  const Misread wronglyBlamed{0, 4, Vertical, 321};
  const Measurement measurement = misreadMeasurement({{0, 4, Horizontal, 900}});
  EXPECT_EQ(judged(measurement, {wronglyBlamed})[0].kind, Horizontal);

  Measurement withSlider = measurement;
  for (Sighting& sighting : withSlider.arcs[0].sightings)
    sighting.slider = Angle::fromDegrees(10 + 10 * (sighting.point - 1));
  expectUntouched(withSlider, wronglyBlamed);
  expectUntouched(withSlider, {0, 4, Slider, 321});

  Measurement withFaces = measurement;
  Sighting twin = withFaces.arcs[0].sightings[4];
  twin.face = 2;
  withFaces.arcs[0].sightings.insert(withFaces.arcs[0].sightings.begin() + 5, twin);
  expectUntouched(withFaces, wronglyBlamed);
  withFaces.arcs[0].sightings[5].face = 1;  // another round counts as another visit
  withFaces.arcs[0].sightings[5].round = 2;
  withFaces.arcs[0].sightings[5].a = misreadMeasurement({}).arcs[0].sightings[4].a;
  EXPECT_EQ(judged(withFaces, {wronglyBlamed})[0].kind, Horizontal);
}

// 15′ above the top of the arc no horizontal reading can correct the row, and the vertical one does not
// determine the place.
TEST(GrossErrorCircle, StaysWhereOneCircleCannotBeCorrected) {
  expectUntouched(misreadMeasurement({{0, 8, Vertical, 900}}), {0, 8, Vertical, 900});
}

}  // namespace
}  // namespace alidade
