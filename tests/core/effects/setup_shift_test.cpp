#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/adjustment/result/closures.h"
#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/diagnose.h"
#include "core/effects/cause_ids.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/simulation/truth_text.h"

// The displacement of the set-up between the positions changes Δd by half of its size and is undetectable in
// any reading.

namespace alidade {
namespace {

Measurement displaced(const char* plan, double x, double y, double* intersection = nullptr) {
  Truth truth = drawTruth(3);
  truth.effects = {{ErrorTerm::SetupShiftX, x}, {ErrorTerm::SetupShiftY, y}};
  if (intersection) *intersection = truth.intersection;
  return *examine(*simulateWithoutNoise(*protocolByName(plan), truth, 3)).measurement;
}

TEST(SetupShift, MovesTheIntersectionByHalfOfItsHeight) {
  double truth = 0;
  const SessionFit fit = fitSession(displaced("paper", 0.3, 0.2, &truth));
  // The second arc is higher and to the right by the shift; the readings are rounded to 1e-6″.
  EXPECT_NEAR(fit.intersection->value, truth - 0.1, 1e-6);
  EXPECT_NEAR(fit.arcs[1].circle.x - fit.arcs[0].circle.x, 0.3, 1e-6);
  for (const ArcFit& arc : fit.arcs) EXPECT_LT(arc.residualRms, 1e-4);
}

TEST(SetupShift, LastsThroughThePositionsAfterTheFirst) {
  const Measurement measurement = displaced("again", 0, 0.2);
  std::vector<Circle> starts;
  for (const ArcFit& arc : fitSession(measurement).arcs) starts.push_back(arc.circle);
  const auto apart = fitApart(measurement, starts, {});
  ASSERT_TRUE(apart);
  std::vector<double> repeats;
  for (const Closure& closure : repeatsOf(measurement, *apart))
    if (closure.repeated->quantity == Unknown::Kind::CentreY) repeats.push_back(closure.value);
  ASSERT_EQ(repeats.size(), 1u);
  EXPECT_NEAR(repeats.front(), 0.2, 1e-5);
}

// The variance of Δd grows by a quarter of the square of the plausible 0.05 mm; U is the only trace.
TEST(SetupShift, TakesPartInTheUncertaintyAndIsNoCause) {
  Measurement measurement = displaced("full", 0, 0.2);
  const SessionFit fit = fitSession(measurement);
  const auto share = [&](const Measurement& of) {
    const auto diagnosis = diagnose(of, fit);
    EXPECT_TRUE(diagnosis && diagnosis->measured);
    for (const Candidate& candidate : diagnosis->candidates) EXPECT_NE(candidate.effect, "setup_shift");
    const auto& budget = diagnosis->measured->budget;
    const auto found = std::ranges::find(budget, "setup_shift", &UncertaintyShare::effect);
    return found == budget.end() ? 0.0 : found->sigma;
  };
  EXPECT_NEAR(share(measurement), 0.025, 0.003) << "a few per cent that all effects of time are larger";
  measurement.known = {{.effect = "setup_shift", .parameter = "shift along y", .unit = "mm", .sigma = 0.01},
                       {.effect = "setup_shift", .parameter = "shift along x", .unit = "mm", .sigma = 0.01}};
  EXPECT_NEAR(share(measurement), 0.005, 1e-4);
}

}  // namespace
}  // namespace alidade
