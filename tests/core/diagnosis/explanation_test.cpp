#include "core/diagnosis/explanation.h"

#include <gtest/gtest.h>

#include "core/adjustment/session_fit.h"
#include "core/diagnosis/known_components.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

TEST(Explanation, IsSoughtNoFurtherOnceStopped) {
  const Measurement measurement = test::trialMeasurement("full");
  const Leftover leftover({linearise(measurement, fitSession(measurement).joint)});
  const std::vector<Component> candidates = effectComponents(leftover, {}, {});
  std::stop_source stop;
  const auto longest = [&] {
    std::size_t most = 0;
    for (const Explanation& found : explain(leftover, candidates, {.stop = stop.get_token()}))
      most = std::max(most, found.parts.size());
    return most;
  };
  EXPECT_GT(longest(), 0U);
  stop.request_stop();
  EXPECT_EQ(longest(), 0U);
}

}  // namespace
}  // namespace alidade
