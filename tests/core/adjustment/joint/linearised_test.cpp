#include "core/adjustment/joint/linearised.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/adjustment/arc/arc_fit.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

JointFit fitOf(const Measurement& measurement, const JointFitOptions& options = {}) {
  std::vector<Circle> starts;
  for (const ArcMeasurement& arc : measurement.arcs) starts.push_back(fitArc(measurement, arc)->circle);
  return fitJointly(measurement, starts, options);
}

// At the solution the residuals are orthogonal to the columns of all free unknowns.
TEST(Linearised, ResidualsStandOnTheFreeUnknowns) {
  for (const char* protocol : {"paper", "paper-slider", "two-face", "full"}) {
    SCOPED_TRACE(protocol);
    const Measurement measurement = test::trialMeasurement(protocol);
    const Linearised linear = linearise(measurement, fitOf(measurement));
    for (std::size_t u = 0; u < linear.unknowns.size(); ++u) {
      if (linear.priors[u].isInformative()) continue;
      double product = 0, squared = 0;
      for (std::size_t i = 0; i < linear.readings.size(); ++i) {
        product += linear.readings[i].residual * linear.ofUnknown(i, u);
        squared += std::pow(linear.ofUnknown(i, u), 2);
      }
      EXPECT_LT(std::abs(product), 1e-6 * std::sqrt(squared));  // the fit stops 1e-9 σ from the minimum
    }
  }
}

// The column agrees with a small collimation added to the readings by the textbook formula, δα = ±c/cos e.
TEST(Linearised, ColumnsOfTermsAreWhatTheTermsDo) {
  const Measurement measurement = test::trialMeasurement("two-face");
  const Linearised linear = linearise(measurement, fitOf(measurement));
  for (std::size_t i = 0; i < linear.readings.size(); ++i) {
    const LinearReading& reading = linear.readings[i];
    const Sighting& sighting = measurement.arcs[reading.arc].sightings[reading.sighting];
    const double side = sighting.face == 1 ? 1 : -1;
    // The pointing zero, read in face 1 on the horizon, has the same error.
    const double expected =
        reading.kind == ReadingKind::Horizontal ? side / std::cos(sighting.e.radians()) - 1 : 0;
    EXPECT_NEAR(linear.ofTerm(i, ErrorTerm::Collimation) * reading.sigma, expected,
                1e-4);  // e is the reading instead of the adjusted value
    EXPECT_EQ(linear.ofTerm(i, ErrorTerm::VerticalJump) != 0, reading.kind == ReadingKind::Vertical);
  }
}

// The fit has a radius known to 0.5 mm and a term with the plausible size 1e-4. The residuals are their
// distances from the prior in σ.
TEST(Linearised, WhatIsKnownBeforehandIsOneRowEach) {
  Measurement measurement = test::trialMeasurement("two-face");
  measurement.radiusModel = RadiusModel::Known;
  measurement.sigmaRadius = 0.5;
  measurement.sigmaDistance = 0;
  const JointFitOptions options{.terms = {{ErrorTerm::Collimation, 1e-4, 2e-5}}};
  const JointFit fit = fitOf(measurement, options);
  const Linearised linear = linearise(measurement, fit, options);

  const std::vector<std::size_t> unknowns = linear.uncertainUnknowns();
  for (std::size_t u = 0; u < linear.unknowns.size(); ++u)  // all but the distance, which is known exactly
    EXPECT_EQ(std::ranges::find(unknowns, u) == unknowns.end(),
              linear.unknowns[u].kind == Unknown::Kind::Distance);

  const std::vector<PriorRow> rows = linear.priorRows(unknowns, options.terms);
  ASSERT_EQ(rows.size(), 6U);  // the radius, two zeros in each position, the term
  const double radius = fit.circleOf(0).radius;
  const std::size_t term = fit.indexOf({.kind = Unknown::Kind::Error, .term = ErrorTerm::Collimation});
  for (const PriorRow& row : rows) {
    const Unknown::Kind kind =
        row.column < unknowns.size() ? linear.unknowns[unknowns[row.column]].kind : Unknown::Kind::Error;
    if (kind == Unknown::Kind::Radius) {
      EXPECT_NEAR(row.residual, (measurement.nominalRadius - radius) / 0.5, 1e-9);
      EXPECT_EQ(row.derivative, 2);
    } else if (kind == Unknown::Kind::Error) {
      EXPECT_EQ(row.column, unknowns.size());
      EXPECT_NEAR(row.residual, (2e-5 - fit.values[term]) / 1e-4, 1e-9);
      EXPECT_EQ(row.derivative, 1 / 1e-4);
    } else {
      EXPECT_EQ(row.residual, 0);  // a zero keeps the value read
      EXPECT_EQ(row.derivative, 1 / measurement.sigmaZeroHorizontal.radians());
    }
  }
}

}  // namespace
}  // namespace alidade
