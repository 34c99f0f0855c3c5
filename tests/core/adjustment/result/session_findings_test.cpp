#include "core/adjustment/result/session_findings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "tests/support/found.h"
#include "tests/support/perfect_session.h"

// Readings without noise: the stated σ then count as known, and 0.1 % of risk is 3.2905 σ (normal tables).

namespace alidade {
namespace {

constexpr double quantile = 3.2905;

Measurement withRadii(double upper, double lower) {
  Measurement measurement = test::usualMeasurement();
  measurement.arcs = {test::perfectArc(measurement, {0, 0, upper}, test::spread(17, 160)),
                      test::perfectArc(measurement, {0, 0, lower}, test::spread(17, 160, -90), 180)};
  return measurement;
}

template <typename Kind>
bool says(const Measurement& measurement) {
  return test::found<Kind>(sessionFindings(measurement, fitSession(measurement))) != nullptr;
}

// For two arcs fitted separately, with exact zeros and distance, σ of the difference is the root of the sum
// of squares.
TEST(SessionFindings, RadiiDifferByMoreThanTheirNoiseAllows) {
  const std::vector<ArcSigma> sigmas = fitSession(withRadii(400, 400)).sigmas;
  const double bound = quantile * std::hypot(sigmas.at(0).radius, sigmas.at(1).radius);
  EXPECT_FALSE(says<session_finding::RadiiDiffer>(withRadii(400, 400 + 0.97 * bound)));
  EXPECT_TRUE(says<session_finding::RadiiDiffer>(withRadii(400, 400 + 1.03 * bound)));
  EXPECT_TRUE(says<session_finding::RadiiDiffer>(withRadii(400 + 1.03 * bound, 400)));
}

TEST(SessionFindings, CentresDifferByMoreThanReadingsAndZerosAllow) {
  const auto apart = [](double x) {
    Measurement measurement = withRadii(400, 400);
    measurement.sigmaZeroHorizontal = Angle::fromArcseconds(3);
    measurement.radiusModel = RadiusModel::Common;
    measurement.arcs[1] = test::perfectArc(measurement, {x, 0, 400}, test::spread(17, 160, -90), 180);
    return measurement;
  };
  const std::vector<ArcSigma> sigmas = fitSession(apart(0)).sigmas;
  const double bound = quantile * std::hypot(sigmas.at(0).x, sigmas.at(1).x);
  for (const double side : {-1.0, 1.0}) {
    EXPECT_FALSE(says<session_finding::CentresDiffer>(apart(side * 0.97 * bound)));
    EXPECT_TRUE(says<session_finding::CentresDiffer>(apart(side * 1.03 * bound)));
  }
  EXPECT_FALSE(says<session_finding::RadiiDiffer>(apart(2 * bound))) << "one radius for both";
}

// The readings' own radius has 1/σ² = 1/σ1² + 1/σ2²; it is independent of R0, so σ of their difference is the
// root of the sum of squares.
TEST(SessionFindings, KnownRadiusIsHeldAgainstWhatTheReadingsSay) {
  Measurement measurement = withRadii(400, 400);
  const std::vector<ArcSigma> sigmas = fitSession(measurement).sigmas;
  const double ofReadings =
      1 / std::sqrt(std::pow(sigmas.at(0).radius, -2) + std::pow(sigmas.at(1).radius, -2));
  measurement.radiusModel = RadiusModel::Known;
  for (const double sigma : {ofReadings / 2, ofReadings * 2}) {
    measurement.sigmaRadius = sigma;
    const double bound = quantile * std::hypot(sigma, ofReadings);
    for (const double side : {-1.0, 1.0}) {
      // 9 % on either side of the bound: with R0 included, the readings do not fit, and s0 is slightly
      // different from 1.
      measurement.nominalRadius = 400 + side * 0.91 * bound;
      EXPECT_FALSE(says<session_finding::KnownRadiusContradicted>(measurement)) << sigma;
      measurement.nominalRadius = 400 + side * 1.09 * bound;
      EXPECT_TRUE(says<session_finding::KnownRadiusContradicted>(measurement)) << sigma;
    }
  }
}

// A free radius is compared with an R0 that has a σ. Readings see R/L, so σ(L) counts by R/L.
TEST(SessionFindings, ANominalRadiusContradictsAFreeOne) {
  for (const double sigmaDistance : {0.0, 0.5}) {
    Measurement measurement = withRadii(400, 400);
    measurement.radiusModel = RadiusModel::Common;
    measurement.sigmaDistance = sigmaDistance;
    const SessionFit fit = fitSession(measurement);
    measurement.sigmaRadius = 0.1;
    const double bound = quantile * std::hypot(0.1, fit.sigmas.at(0).radius);
    for (const double side : {-1.0, 1.0}) {
      measurement.nominalRadius = 400 + side * 0.95 * bound;
      EXPECT_FALSE(says<session_finding::NominalRadiusContradicted>(measurement)) << sigmaDistance;
      measurement.nominalRadius = 400 + side * 1.05 * bound;
      EXPECT_TRUE(says<session_finding::NominalRadiusContradicted>(measurement)) << sigmaDistance;
    }
  }
}

TEST(SessionFindings, APositionIsACopy) {
  Measurement measurement = withRadii(400, 400);
  measurement.arcs.push_back(measurement.arcs[0]);
  measurement.arcs[2].repeat = 2;
  EXPECT_TRUE(says<session_finding::PositionCopied>(measurement));
  measurement.arcs[2].sightings[5].a = measurement.arcs[2].sightings[5].a + Angle::fromArcseconds(0.1);
  EXPECT_FALSE(says<session_finding::PositionCopied>(measurement));
}

}  // namespace
}  // namespace alidade
