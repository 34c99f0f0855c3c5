#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "tests/support/found.h"
#include "tests/support/paper_table.h"
#include "tests/support/trials.h"

// A common or a known radius (`model.radius`).

namespace alidade {
namespace {

using Vector = std::vector<double>;

Measurement with(RadiusModel model, Measurement measurement, double sigmaRadius = 0) {
  measurement.radiusModel = model;
  measurement.sigmaRadius = sigmaRadius;
  return measurement;
}

constexpr Unknown radius(std::size_t arc) {
  return {.kind = Unknown::Kind::Radius, .arc = arc};
}

/// Estimates and their covariance.
struct Gaussian {
  Vector mean;
  SquareMatrix covariance;

  /// The update of Bayes and Kalman after hᵀθ is observed as `value` with `variance`.
  void observe(const Vector& h, double value, double variance) {
    const std::size_t n = mean.size();
    Vector gain(n);
    double predicted = 0, spread = variance;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) gain[i] += covariance(i, j) * h[j];
      predicted += h[i] * mean[i];
      spread += h[i] * gain[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
      mean[i] += gain[i] * (value - predicted) / spread;
      for (std::size_t j = 0; j < n; ++j) covariance.values[i * n + j] -= gain[i] * gain[j] / spread;
    }
  }
};

// The free fit with R1 = R2 and R = R0 as additional observations equals the fit with a common or known
// radius, in closed form. The curvature of the model is neglected: radii change by some 0.1 mm, with a
// curvature of some 1e-4.
TEST(RadiusModel, IsTheFreeFitConditioned) {
  for (const char* protocol : {"paper", "full"}) {
    const Measurement measurement = test::trialMeasurement(protocol);
    const JointFit free = fitSession(measurement).joint;
    Gaussian expected{free.values, free.cofactor};
    Vector difference(free.values.size()), first(free.values.size());
    difference[free.indexOf(radius(0))] = first[free.indexOf(radius(0))] = 1;
    difference[free.indexOf(radius(1))] = -1;
    expected.observe(difference, 0, 0);
    const auto expectThat = [&](const Measurement& constrained) {
      const JointFit fit = fitSession(constrained).joint;
      EXPECT_TRUE(fit.converged());
      for (std::size_t i = 0; i < free.unknowns.size(); ++i) {
        const std::size_t here = fit.indexOf(free.unknowns[i]);
        EXPECT_NEAR(fit.values[here], expected.mean[i], 2e-5) << protocol << i;
        EXPECT_NEAR(fit.cofactor(here, here), expected.covariance(i, i),
                    1e-3 * expected.covariance(i, i) + 2e-12)
            << protocol << i;
      }
    };
    expectThat(with(RadiusModel::Common, measurement));
    constexpr double sigma = 0.02;
    Gaussian known = expected;
    expected.observe(first, measurement.nominalRadius, sigma * sigma);
    expectThat(with(RadiusModel::Known, measurement, sigma));
    expected = known;
    expected.observe(first, measurement.nominalRadius, 1e-12);
    expectThat(with(RadiusModel::Known, measurement));
  }
}

// Minima found by another solver (Gauss-Newton steps on centres and radius by differences, every arc angle at
// its foot) from Table I, which agrees with its own finer steps to some 1e-7 mm.
TEST(RadiusModel, MeetsAnotherSolverOnTableI) {
  struct Case {
    RadiusModel model;
    double sigma, radius, y0, y180;
  };
  for (const Case& c : {Case{RadiusModel::Common, 0, 402.9426260767, -0.2195595818, -2.8130451860},
                        Case{RadiusModel::Known, 0.05, 402.8135592195, -0.0556041110, -2.9769202900},
                        Case{RadiusModel::Known, 0, 400.0, 3.5163630614, -6.5469048783}}) {
    const SessionFit fit = fitSession(with(c.model, test::paperMeasurement(), c.sigma));
    ASSERT_EQ(fit.arcs.size(), 2u);
    EXPECT_TRUE(fit.joint.converged());
    EXPECT_NEAR(fit.arcAt(0)->circle.radius, c.radius, 2e-6);
    EXPECT_EQ(fit.arcAt(0)->circle.radius, fit.arcAt(180)->circle.radius);
    EXPECT_NEAR(fit.arcAt(0)->circle.y, c.y0, 2e-6);
    EXPECT_NEAR(fit.arcAt(180)->circle.y, c.y180, 2e-6);
  }
}

double entryOf(const Intersection& intersection, UncertaintySource source) {
  for (const BudgetEntry& entry : intersection.budget)
    if (entry.source == source) return entry.sigma;
  return -1;
}

// The readings' share is the effect of independent errors of every reading on Δd, the radius' share that of a
// radius error of its σ: both compared with the budget.
TEST(RadiusModel, BudgetHoldsReadingsAndRadiusApart) {
  const double sigma = 0.02;
  const Measurement measurement = with(RadiusModel::Known, test::trialMeasurement("paper"), sigma);
  const SessionFit fit = fitSession(measurement);
  double variance = 0;
  for (const AdjustedReading& reading : fit.joint.readings)
    variance += std::pow(reading.perReading * reading.sigma, 2);
  // With residuals of a few σ the linear shares are accurate to some 1e-4.
  EXPECT_NEAR(entryOf(*fit.intersection, UncertaintySource::Readings), fit.noise.factor * std::sqrt(variance),
              1e-4 * std::sqrt(variance));

  Measurement moved = measurement;
  moved.nominalRadius += 0.01;
  const double change = std::abs(fitSession(moved).intersection->value - fit.intersection->value);
  const double share = entryOf(*fit.intersection, UncertaintySource::KnownRadius);
  EXPECT_GT(share, 0.001);
  EXPECT_NEAR(change / 0.01 * sigma, share, 1e-3 * share);
  EXPECT_EQ(
      entryOf(*fitSession(test::trialMeasurement("paper")).intersection, UncertaintySource::KnownRadius), -1);
}

// The redundancies of readings and R0 add up to the degrees of freedom: the trace of a projector.
TEST(RadiusModel, RedundanciesAddUpToTheDegreesOfFreedom) {
  const Measurement measurement = test::trialMeasurement("paper");
  const int free = fitSession(measurement).joint.degreesOfFreedom;
  const JointFit common = fitSession(with(RadiusModel::Common, measurement)).joint;
  EXPECT_EQ(common.degreesOfFreedom, free + 1);
  const double sigma = 0.02;
  const JointFit known = fitSession(with(RadiusModel::Known, measurement, sigma)).joint;
  EXPECT_EQ(known.degreesOfFreedom, free + 2);
  const std::size_t r = known.indexOf(radius(0));
  double sum = 1 - known.cofactor(r, r) / (sigma * sigma);
  for (const AdjustedReading& reading : known.readings) sum += reading.redundancy;
  EXPECT_NEAR(sum, known.degreesOfFreedom, 1e-6);
}

// On an upper arc a larger radius lowers the centre, on a lower arc it raises it; a known radius has no
// correlation.
TEST(RadiusModel, CorrelationWithTheCentreIsStated) {
  const Measurement measurement = test::paperMeasurement();
  const SessionFit free = fitSession(measurement);
  EXPECT_LT(free.sigmas[0].radiusY, -0.4);
  EXPECT_GT(free.sigmas[1].radiusY, 0.4);
  EXPECT_LT(std::abs(free.sigmas[0].radiusX), 0.1);
  // The reference is the definition, with readings as the only source.
  Measurement exactZeros = measurement;
  exactZeros.sigmaZeroHorizontal = exactZeros.sigmaZeroVertical = Angle();
  const SessionFit fit = fitSession(exactZeros);
  const Covariance3& q = fit.arcs[0].cofactor;
  EXPECT_NEAR(fit.sigmas[0].radiusY, q[1][2] / std::sqrt(q[1][1] * q[2][2]), 1e-9);
  EXPECT_NEAR(fit.sigmas[0].radiusX, q[0][2] / std::sqrt(q[0][0] * q[2][2]), 1e-9);
  EXPECT_NEAR(fitSession(with(RadiusModel::Known, exactZeros)).sigmas[0].radiusY, 0, 1e-3);
}

TEST(RadiusModel, AConflictWithTheKnownRadiusIsSaid) {
  const auto isSaid = [](const Measurement& measurement) {
    return test::found<session_finding::KnownRadiusContradicted>(fitSession(measurement).findings) != nullptr;
  };
  EXPECT_TRUE(isSaid(with(RadiusModel::Known, test::paperMeasurement(), 0.05)));
  Measurement agreeing = test::trialMeasurement("paper");
  agreeing.nominalRadius = fitSession(agreeing).arcs[0].circle.radius;
  EXPECT_FALSE(isSaid(with(RadiusModel::Known, agreeing, 0.05)));
}

TEST(RadiusModel, HoldsForOnePosition) {
  Measurement measurement = test::trialMeasurement("paper");
  measurement.arcs.pop_back();
  const SessionFit free = fitSession(measurement);
  const SessionFit common = fitSession(with(RadiusModel::Common, measurement));
  ASSERT_EQ(common.arcs.size(), 1u);
  EXPECT_NEAR(common.arcs[0].circle.y, free.arcs[0].circle.y, 1e-9);
  EXPECT_EQ(common.joint.degreesOfFreedom, free.joint.degreesOfFreedom);
  const SessionFit known = fitSession(with(RadiusModel::Known, measurement));
  EXPECT_NEAR(known.arcs[0].circle.radius, 400, 1e-6);
  EXPECT_LT(known.sigmas[0].y, free.sigmas[0].y);
}

}  // namespace
}  // namespace alidade
