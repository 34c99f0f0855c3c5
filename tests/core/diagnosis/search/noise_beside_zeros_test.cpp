#include <gtest/gtest.h>

#include "core/diagnosis/diagnose.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

namespace alidade::test {
namespace {

// One of four sightings of the zero is misread. Its σ is stated, so larger noise of the readings does not
// explain it; U grows by the difference that is left, and not with the rounds of a search for the noise.
TEST(NoiseBesideZeros, DoesNotGrowWithTheirContradiction) {
  for (const double error : {20.0, 60.0, 200.0}) {
    Truth truth = drawTruth(2);
    truth.sightsZerosInFull = true;
    Measurement measurement = *examine(*simulate(*protocolByName("paper"), truth, 2)).measurement;
    measurement.arcs[0].zeroSightings[0].a =
        measurement.arcs[0].zeroSightings[0].a + Angle::fromArcseconds(error);
    const auto diagnosis = diagnose(measurement);
    ASSERT_TRUE(diagnosis);
    EXPECT_LT(diagnosis->measured->estimate.expanded, 2) << error;
    EXPECT_LT(diagnosis->noise, 20) << error;
  }
}

}  // namespace
}  // namespace alidade::test
