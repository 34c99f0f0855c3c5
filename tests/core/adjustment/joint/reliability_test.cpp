#include "core/adjustment/joint/reliability.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/arc/arc_fit.h"
#include "core/adjustment/result/session_fit.h"
#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

// Baarda's δ0 at 0.1 % risk and 80 % power is 4.13 in every textbook.
TEST(Reliability, MeetsBaardasShift) {
  const Reliability reliability = reliabilityOf({.sigma = 1, .redundancy = 1, .perReading = -0.5});
  EXPECT_NEAR(reliability.minimalDetectableBias.radians(), 4.13, 0.005);
  EXPECT_NEAR(reliability.influence, -0.5 * 4.13, 0.005);
  EXPECT_NEAR(reliabilityOf({.sigma = 2, .redundancy = 0.25}).minimalDetectableBias.radians(), 4 * 4.13,
              0.02);
}

// The normal quantiles of the tables: z(97.5 %) 1.960, z(99.95 %) 3.291, z(80 %) 0.842, z(90 %) 1.282.
TEST(Reliability, ShiftIsThatOfTheLevelAskedFor) {
  const auto shiftAt = [](const DetectionLevel& level) {
    return reliabilityOf({.sigma = 1, .redundancy = 1}, level).minimalDetectableBias.radians();
  };
  EXPECT_NEAR(shiftAt({.risk = 0.05, .power = 0.80}), 1.960 + 0.842, 0.001);
  EXPECT_NEAR(shiftAt({.risk = 0.05, .power = 0.90}), 1.960 + 1.282, 0.001);
  EXPECT_NEAR(shiftAt({.risk = 0.001, .power = 0.90}), 3.291 + 1.282, 0.001);
}

TEST(Reliability, OfAReadingThatNothingChecksIsInfinite) {
  const Reliability reliability = reliabilityOf({.sigma = 1, .redundancy = 0, .perReading = 0.5});
  EXPECT_TRUE(std::isinf(reliability.minimalDetectableBias.radians()));
  EXPECT_TRUE(std::isinf(reliability.influence));
  EXPECT_EQ(reliabilityOf({.sigma = 1, .redundancy = 0, .perReading = 0}).influence, 0);
}

// An error of the minimal size put into a reading is found by its standardised residual in 80 % of simulated
// sessions; of 2000 the share scatters by 0.9 %.
TEST(Reliability, FindsWhatItPromises) {
  Measurement measurement = test::usualMeasurement();
  measurement.arcs = {test::perfectArc(measurement, {0, 0, 400}, test::spread(11, 150))};
  const Circle start{0, 0, 400};
  constexpr std::size_t probed = 4;  // the third place's horizontal reading, some 45° up the arc
  const AdjustedReading clean = fitJointly(measurement, {start}).readings.at(probed);
  ASSERT_EQ(clean.kind, ReadingKind::Horizontal);
  const Angle bias = reliabilityOf(clean).minimalDetectableBias;
  std::mt19937_64 generator(31);
  constexpr int count = 2000;
  int found = 0;
  for (int i = 0; i < count; ++i) {
    Measurement noisy = measurement;
    test::addNoise(noisy.arcs[0], noisy, generator);
    Sighting& sighting = noisy.arcs[0].sightings[clean.sighting];
    sighting.a = sighting.a + bias;
    const AdjustedReading reading = fitJointly(noisy, {start}).readings.at(probed);
    found += std::abs(reading.residual) / (reading.sigma * std::sqrt(reading.redundancy)) > 3.2905;
  }
  EXPECT_NEAR(static_cast<double>(found) / count, 0.80, 0.04);
}

}  // namespace
}  // namespace alidade
