#include "core/diagnosis/candidates/shape_components.h"

#include <gtest/gtest.h>

#include "core/diagnosis/diagnose.h"
#include "core/session/measurement.h"
#include "core/simulation/simulate.h"

namespace alidade {
namespace {

// If the noise of a circle is large compared with the span of the arc, a pattern over observed directions
// would follow the noise. Here it explained nine tenths of χ² in each of 100 sessions without any effect. A
// diagnosis names a cause in 2 % of sound sessions; of 30, more than 4 occur by chance once in 2000 times.
TEST(ShapeComponents, DoNotFollowTheNoiseOfTheDirections) {
  Protocol protocol{.name = "short arc", .description = {}, .points = 21};
  protocol.step = Angle::fromDegrees(1.2);
  protocol.first = Angle::fromDegrees(80);
  protocol.rounds = 2;
  int named = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Truth truth = drawTruth(seed);
    truth.distance = 4000;
    truth.radius = truth.nominalRadius = 63;
    truth.sigmaHorizontal = Angle::fromArcseconds(50);
    const Result<Session> session = simulate(protocol, truth, seed);
    ASSERT_TRUE(session);
    const auto diagnosis = diagnose(*examine(*session).measurement);
    ASSERT_TRUE(diagnosis);
    named += diagnosis->verdict == DiagnosisVerdict::WithinNoise ? 0 : 1;
  }
  EXPECT_LE(named, 4);
}

}  // namespace
}  // namespace alidade
