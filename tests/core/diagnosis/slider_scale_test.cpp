#include <gtest/gtest.h>

#include <cstdint>

#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/next_sighting.h"
#include "core/guidance/sighting_choice.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

namespace alidade::test {
namespace {

Measurement withScaleFrom(Measurement measurement, double zeroDeg) {
  for (ArcMeasurement& arc : measurement.arcs)
    for (Sighting& sighting : arc.sightings)
      if (sighting.slider)
        sighting.slider = wrapped(*sighting.slider + Angle::fromDegrees(zeroDeg), Angle::fromDegrees(180));
  return measurement;
}

// The zero of the slider's scale is an unknown of each arc, so no answer depends on where the scale begins:
// 1e-6 of U is rounding. At 180° half of the readings minus places are wrapped.
TEST(SliderScale, MayBeginAnywhere) {
  for (const char* protocol : {"paper-slider", "full"})
    for (const std::uint64_t seed : {11U, 12U, 13U}) {
      const Measurement read =
          *examine(*simulate(*protocolByName(protocol), drawTruth(seed), seed)).measurement;
      const IntersectionEstimate asRead = diagnose(read)->measured->estimate;
      for (const double zero : {20.0, 90.0, 179.99, 180.0, 270.0}) {
        const auto diagnosis = diagnose(withScaleFrom(read, zero));
        ASSERT_TRUE(diagnosis) << protocol << seed << ' ' << zero;
        const IntersectionEstimate& estimate = diagnosis->measured->estimate;
        EXPECT_NEAR(estimate.value, asRead.value, 1e-6 * asRead.expanded) << protocol << seed << ' ' << zero;
        EXPECT_NEAR(estimate.expanded, asRead.expanded, 1e-6 * asRead.expanded)
            << protocol << seed << ' ' << zero;
      }
    }
}

// The same of the causes that are weighed while a session grows. Their equations are linearised at circles
// that are found to 2e-3 mm, so chances agree to 1e-2.
TEST(SliderScale, IsNoEvidenceWhileASessionGrows) {
  const Measurement read =
      *examine(*simulate(*protocolByName("paper-slider"), drawTruth(11), 11)).measurement;
  const SightingPlan plan = openPlan(templateOf(*protocolByName("paper-slider")));
  const double asRead = sessionSoFar(read, plan)->logEvidence;
  for (const double zero : {20.0, 90.0, 180.0})
    EXPECT_NEAR(sessionSoFar(withScaleFrom(read, zero), plan)->logEvidence, asRead, 1e-2) << zero;
}

}  // namespace
}  // namespace alidade::test
