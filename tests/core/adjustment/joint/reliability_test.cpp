#include "core/adjustment/joint/reliability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/adjustment/gross_errors/gross_error_search.h"
#include "core/adjustment/result/session_fit.h"
#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

using enum ReadingKind;

TEST(Reliability, IsTheDetectableShiftInTheNoiseThatIsThere) {
  const Detection detection{.scale = 3, .shift = 5};
  const Reliability reliability =
      reliabilityOf({.sigma = 2, .redundancy = 0.25, .perReading = -0.5}, detection);
  EXPECT_DOUBLE_EQ(reliability.minimalDetectableBias.radians(), 5 * 3 * 2 / 0.5);
  EXPECT_DOUBLE_EQ(reliability.influence, -0.5 * 60);
}

// Table I: 89.76″ from a noncentral t with 27 degrees of freedom that exceeds 4.1522 in 80 % of cases,
// integrated numerically, at s0 = 6.9119 and r = 0.61173; the approximation may add 0.04 %.
TEST(Reliability, OfTheFirstReadingOfTableI) {
  const SessionFit fit = fitSession(test::paperMeasurement());
  const Detection detection = detectionIn(fit.joint, fit.noise.factor);
  const Reliability reliability = reliabilityOf(fit.joint.readings.front(), detection);
  EXPECT_NEAR(reliability.minimalDetectableBias.arcseconds(), 89.76, 0.04);
}

TEST(Reliability, OfAReadingThatNothingChecksIsInfinite) {
  const Detection detection{.shift = 5};
  const Reliability reliability = reliabilityOf({.sigma = 1, .redundancy = 0, .perReading = -0.5}, detection);
  EXPECT_EQ(reliability.minimalDetectableBias.radians(), INFINITY);
  EXPECT_EQ(reliability.influence, -INFINITY);
  EXPECT_EQ(reliabilityOf({.sigma = 1, .redundancy = 0, .perReading = 0}, detection).influence, 0);
}

// Four places leave one degree of freedom to an arc, which the tested shift uses.
TEST(Reliability, IsInfiniteWhereNoScatterIsLeftToTestBy) {
  Measurement measurement = test::usualMeasurement();
  measurement.arcs = {test::perfectArc(measurement, {0, 0, 400}, test::spread(4, 150))};
  const JointFit fit = fitJointly(measurement, {{0, 0, 400}});
  ASSERT_EQ(fit.degreesOfFreedom, 1);
  ASSERT_TRUE(fit.readings.front().isChecked());
  const Reliability reliability = reliabilityOf(fit.readings.front(), detectionIn(fit, 1));
  EXPECT_TRUE(std::isinf(reliability.minimalDetectableBias.radians()));
}

/// One arc of `places`, in one face or in two.
Measurement oneArc(int places, int faces) {
  Measurement measurement = test::usualMeasurement();
  const ArcMeasurement oneFace = test::perfectArc(measurement, {0, 0, 400}, test::spread(places, 150));
  measurement.arcs = {oneFace};
  for (Sighting second : oneFace.sightings) {
    second.face = 2;
    second.row += oneFace.sightings.size();
    if (faces == 2) measurement.arcs[0].sightings.push_back(second);
  }
  return measurement;
}

/// Returns how often the search for misread readings names an error of the minimal size in reading `cell`.
double shareFound(const Measurement& perfect, const ReadingRef& cell, int sessions) {
  const Circle start{0, 0, 400};
  const JointFit clean = fitJointly(perfect, {start});
  const auto reading = std::ranges::find_if(clean.readings, [&](const AdjustedReading& adjusted) {
    return adjusted.sighting == cell.sighting && adjusted.kind == cell.kind;
  });
  const Angle bias = reliabilityOf(*reading, detectionIn(clean, 1)).minimalDetectableBias;
  std::mt19937_64 generator(31);
  int found = 0;
  for (int i = 0; i < sessions; ++i) {
    Measurement noisy = perfect;
    test::addNoise(noisy.arcs[0], noisy, generator);
    shiftReading(noisy, cell, -bias);
    const GrossErrorSearch search = searchGrossErrors(noisy);
    found += std::ranges::any_of(search.grossErrors, [&](const GrossError& error) {
      return error.cell.sighting == cell.sighting;  // either circle of a single row may be named
    });
  }
  return static_cast<double>(found) / sessions;
}

// The search itself finds the error in 80 % of simulated sessions with one error of the minimal size. For
// 1500 sessions the share scatters by 1 %; three times that is allowed.
TEST(Reliability, FindsWhatItPromises) {
  EXPECT_NEAR(shareFound(oneArc(17, 1), {0, 2, Horizontal}, 1500), 0.80, 0.03);
  EXPECT_NEAR(shareFound(oneArc(9, 2), {0, 3, Vertical}, 1500), 0.80, 0.03);
}

// For few readings the approximation is slightly pessimistic: 81.4 % with 2 degrees of freedom.
TEST(Reliability, FindsMoreThanItPromisesWhereFewReadingsAreThere) {
  EXPECT_NEAR(shareFound(oneArc(6, 1), {0, 1, Horizontal}, 1500), 0.814, 0.03);
}

// Compares another method: the search fits the reading's shift and divides by the scatter of all others. In
// linear theory its t is w √((f − 1)/(f − w²)) of the fit of all readings (A. J. Pope, 1976).
TEST(Reliability, StandardisedResidualIsTheSearchsTest) {
  Measurement measurement = oneArc(17, 2);
  std::mt19937_64 generator(8);
  test::addNoise(measurement.arcs[0], measurement, generator);
  const ReadingRef cell{0, 5, Vertical};
  shiftReading(measurement, cell, Angle::fromArcseconds(-40));
  const SessionFit fit = fitSession(measurement);
  const auto reading = std::ranges::find_if(fit.joint.readings, [&](const AdjustedReading& adjusted) {
    return adjusted.sighting == cell.sighting && adjusted.kind == cell.kind;
  });
  const double w = reading->standardised(fit.noise.factor), f = fit.joint.degreesOfFreedom;
  const GrossErrorSearch search = searchGrossErrors(measurement);
  ASSERT_EQ(search.grossErrors.size(), 1u);
  ASSERT_EQ(search.grossErrors[0].cell, cell);
  EXPECT_NEAR(w * std::sqrt((f - 1) / (f - w * w)), search.grossErrors[0].studentised,
              1e-3 * std::abs(search.grossErrors[0].studentised));
  EXPECT_DOUBLE_EQ(fit.arcs[0].residuals[cell.sighting].verticalStandardised, w);
}

}  // namespace
}  // namespace alidade
