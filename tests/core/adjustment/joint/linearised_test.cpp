#include "core/adjustment/joint/linearised.h"

#include <gtest/gtest.h>

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

// At the solution the residuals are at right angles to everything the fit was free to change.
TEST(Linearised, ResidualsStandOnTheFreeUnknowns) {
  for (const char* protocol : {"paper", "paper-slider", "two-face", "full"}) {
    SCOPED_TRACE(protocol);
    const Measurement measurement = test::trialMeasurement(protocol);
    const Linearised linear = linearise(measurement, fitOf(measurement));
    for (std::size_t u = 0; u < linear.unknowns.size(); ++u) {
      if (!std::isinf(linear.priorSigmas[u])) continue;
      double product = 0, squared = 0;
      for (std::size_t i = 0; i < linear.readings.size(); ++i) {
        product += linear.readings[i].residual * linear.ofUnknown(i, u);
        squared += std::pow(linear.ofUnknown(i, u), 2);
      }
      EXPECT_LT(std::abs(product), 1e-6 * std::sqrt(squared));  // the fit stops 1e-9 σ from the minimum
    }
  }
}

// A small collimation put into the readings by its textbook formula, δα = ±c/cos e, is what the column says.
TEST(Linearised, ColumnsOfTermsAreWhatTheTermsDo) {
  const Measurement measurement = test::trialMeasurement("two-face");
  const Linearised linear = linearise(measurement, fitOf(measurement));
  for (std::size_t i = 0; i < linear.readings.size(); ++i) {
    const LinearReading& reading = linear.readings[i];
    const Sighting& sighting = measurement.arcs[reading.arc].sightings[reading.sighting];
    const double side = sighting.face == 1 ? 1 : -1;
    // The pointing zero, read in face 1 on the horizon, has the error as well.
    const double expected =
        reading.kind == ReadingKind::Horizontal ? side / std::cos(sighting.e.radians()) - 1 : 0;
    EXPECT_NEAR(linear.ofTerm(i, ErrorTerm::Collimation) * reading.sigma, expected,
                1e-4);  // e is read, not adjusted
    EXPECT_EQ(linear.ofTerm(i, ErrorTerm::VerticalJump) != 0, reading.kind == ReadingKind::Vertical);
  }
}

}  // namespace
}  // namespace alidade
