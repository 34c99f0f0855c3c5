#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/gap/gap_model.h"
#include "core/session/measurement.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

// Pointing zeros that are sighted several times, in all parts of a fit.

namespace alidade {
namespace {

struct Sighted {
  Truth truth;
  Session session;

  Measurement measurement() const { return *examine(session).measurement; }
};

/// Returns a session without noise, by a plan in both faces with slider readings.
Sighted sighted(bool inFull, std::initializer_list<TrueSize> effects = {}) {
  Sighted sighted{drawTruth(11), {}};
  sighted.truth.sightsZerosInFull = inFull;
  sighted.truth.effects = effects;
  sighted.session = *simulateWithoutNoise(*protocolByName("full"), sighted.truth, 11);
  return sighted;
}

double shareOfZeros(const SessionFit& fit) {
  for (const BudgetEntry& entry : fit.intersection->budget)
    if (entry.source == UncertaintySource::PointingZeros) return entry.sigma;
  return 0;
}

/// The largest distance of a centre from its true place.
double centresOff(const SessionFit& fit, const Truth& truth) {
  double most = 0;
  for (const ArcFit& arc : fit.arcs) {
    const double y = truth.axisHeight + (arc.axisDeg == 0 ? 1 : -1) * truth.intersection;
    most = std::max(most, std::hypot(arc.circle.x - truth.centreX, arc.circle.y - y));
  }
  return most;
}

// The model includes the faces and moments of the zeros: with the effects estimated, the circles are right.
// The readings are rounded to 1e-6″, and with σ of 0.01″ the priors have little weight.
TEST(ZeroSightings, AreOfTheOneForwardModel) {
  Sighted full = sighted(true, {{ErrorTerm::Collimation, 40},
                                {ErrorTerm::VerticalIndex, -30},
                                {ErrorTerm::VerticalCircleCosine, 8},
                                {ErrorTerm::VerticalDrift, 20},
                                {ErrorTerm::HorizontalDrift, -15}});
  full.session.instrument.sigmaHorizontalArcsec = full.session.instrument.sigmaVerticalArcsec = "0.01";
  full.session.instrument.sigmaSliderArcsec = full.session.instrument.sigmaZeroArcsec = "0.01";
  EXPECT_GT(fitSession(full.measurement()).arcs[0].residualRms, 10);
  full.session.model.effects = {"collimation", "vertical_index", "vertical_circle_eccentricity",
                                "vertical_drift", "horizontal_drift"};
  const SessionFit fit = fitSession(full.measurement());
  for (const ArcFit& arc : fit.arcs) EXPECT_LT(arc.residualRms, 1e-4);
  EXPECT_LT(centresOff(fit, full.truth), 1e-4) << "a zero in face 1 alone would put them off by 0.5 mm";
}

// If the zero of each position is sighted next to its first row, a drift does not change Δd: both positions
// are equally delayed. The same holds if the zero is sighted before and after the rows. One zero for both
// positions would leave L D/4.
TEST(ZeroSightings, BeforeAndAfterTakeADriftOut) {
  const double drift = Angle::fromArcseconds(30).radians();
  const auto movedBy = [&](bool inFull) {
    const Sighted with = sighted(inFull, {{ErrorTerm::VerticalDrift, 30}});
    return std::abs(fitSession(with.measurement()).intersection->value - with.truth.intersection);
  };
  for (const bool inFull : {false, true}) EXPECT_LT(movedBy(inFull), 0.03 * 2405 * drift / 4);
}

// Four sightings without noise, two in each face, have half the uncertainty of a single one.
TEST(ZeroSightings, BringAsMuchAsTheirMeanIsUncertain) {
  const SessionFit once = fitSession(sighted(false).measurement()),
                   full = fitSession(sighted(true).measurement());
  EXPECT_NEAR(shareOfZeros(full) / shareOfZeros(once), 0.5, 1e-6);
  EXPECT_NEAR(full.intersection->value, once.intersection->value, 1e-6);
}

/// A fit's measurement with zeros that scatter by this multiple of the stated σ.
Measurement scattering(double times, bool areReadings) {
  Measurement measurement = sighted(true).measurement();
  measurement.zeroScatter = times;
  measurement.zerosAreReadings = areReadings;
  return measurement;
}

// Zeros scatter by the larger of their own scatter and, if they are circle readings, that of the circles, but
// not by both. The readings of a session without noise scatter by a tenth of the stated σ, so s0 scales
// nothing.
TEST(ZeroSightings, CountAsTheyScatter) {
  const double asStated = shareOfZeros(fitSession(scattering(1, false)));
  EXPECT_NEAR(shareOfZeros(fitSession(scattering(3, false))) / asStated, 3, 1e-9);
  EXPECT_NEAR(shareOfZeros(fitSession(scattering(3, true))) / asStated, 3, 1e-9);
  const auto noisy = [](double scatter) {
    Measurement measurement = scattering(scatter, true);
    for (Angle* sigma : {&measurement.sigmaHorizontal, &measurement.sigmaVertical, &measurement.sigmaSlider})
      *sigma = *sigma * 0.2;
    std::size_t i = 0;
    for (ArcMeasurement& arc : measurement.arcs)
      for (Sighting& sighting : arc.sightings)
        sighting.e = sighting.e + Angle::fromArcseconds(i++ % 2 == 0 ? 2 : -2);
    return fitSession(measurement);
  };
  const double s0 = noisy(1).noise.factor;
  ASSERT_GT(s0, 2);
  EXPECT_NEAR(shareOfZeros(noisy(1)) / asStated, s0, 1e-4 * s0);
  EXPECT_NEAR(shareOfZeros(noisy(1.5)) / asStated, s0, 1e-4 * s0);
  EXPECT_NEAR(shareOfZeros(noisy(3 * s0)) / asStated, 3 * s0, 1e-4 * s0);
}

// As above, with a larger noise that the diagnosis assumes.
TEST(ZeroSightings, ScatterAsTheNoiseIsTakenFor) {
  for (const double scatter : {1.0, 2.0, 5.0}) {
    const Measurement before = scattering(scatter, true), after = withNoise(before, 3);
    EXPECT_NEAR(after.sigmaOfZeroVertical(after.arcs[0]).arcseconds(),
                before.sigmaZeroVertical.arcseconds() * std::max(3.0, scatter) / 2, 1e-12);
  }
}

// Compares draws with the budget where only zeros matter; 10⁵ draws determine σ to 0.3 %.
TEST(ZeroSightings, AreDrawnAsTheirMeanIsUncertain) {
  for (const bool hasTerms : {false, true}) {
    Measurement measurement = scattering(2, false);
    measurement.sigmaZeroHorizontal = measurement.sigmaZeroVertical = Angle::fromArcseconds(60);
    if (hasTerms) measurement.effects = {"gravity_sag"};
    const SessionFit fit = fitSession(measurement);
    const auto draws = propagateDistributions(measurement, fit, {.draws = hasTerms ? 20'000 : 100'000});
    ASSERT_TRUE(draws);
    EXPECT_NEAR(draws->intersection->sigma / fit.intersection->sigma, 1, hasTerms ? 0.03 : 0.015);
    EXPECT_GT(shareOfZeros(fit), 0.9 * fit.intersection->sigma);
  }
}

}  // namespace
}  // namespace alidade
