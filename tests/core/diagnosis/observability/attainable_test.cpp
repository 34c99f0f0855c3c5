#include "core/diagnosis/observability/attainable.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/plan_review.h"
#include "core/effects/catalogue.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/support/large_session.h"

namespace alidade {
namespace {

Measurement cleanBy(const char* protocol) {
  return *examine(*simulateWithoutNoise(*protocolByName(protocol), drawTruth(3), 3)).measurement;
}

Diagnosis diagnosisOf(const Measurement& measurement) {
  return *diagnose(measurement, {.withAttainable = true});
}

std::vector<AttainableUncertainty> attainableBy(const Measurement& measurement) {
  return reviewPlan(measurement)->attainable;
}

double expandedWith(const std::vector<AttainableUncertainty>& list, const std::vector<Measure>& measures) {
  const auto found = std::ranges::find(list, measures, &AttainableUncertainty::measures);
  return found == list.end() ? 0 : found->expanded;
}

// What is promised of slider readings or the other face is what a plan with them has. Its places are others
// by what they are spread by, and its rounds may be more: 5 %.
TEST(Attainable, IsWhatThePlanWithMoreHas) {
  const auto paper = attainableBy(cleanBy("paper"));
  EXPECT_NEAR(
      expandedWith(paper, {Measure::SliderReadings}) / attainableBy(cleanBy("paper-slider"))[0].expanded, 1,
      0.05);
}

// What is measured of a plan's own perfect readings, up to what else may explain even these.
TEST(Attainable, BeginsWithWhatTheReadingsThemselvesHave) {
  for (const char* plan : {"paper", "paper-slider", "two-face", "full"}) {
    const Measurement measurement = cleanBy(plan);
    const Diagnosis diagnosis = diagnosisOf(measurement);
    ASSERT_FALSE(diagnosis.attainable.empty()) << plan;
    EXPECT_NEAR(diagnosis.attainable[0].expanded / diagnosis.measured->estimate.expanded, 1, 0.1) << plan;
    // A plan has every effect at its plausible size; that they are larger is a little probable in readings.
    EXPECT_NEAR(diagnosis.attainable[0].expanded / attainableBy(measurement)[0].expanded, 1.05, 0.05) << plan;
  }
}

// A certificate that says nearly nothing is left open brings U down to what was promised of it.
TEST(Attainable, OfAKnownEffectIsWhatACertificateBrings) {
  for (const char* plan : {"paper", "two-face"}) {
    Measurement measurement = cleanBy(plan);
    const auto list = attainableBy(measurement);
    const auto known = std::ranges::find_if(list, [](const auto& one) { return !one.known.empty(); });
    ASSERT_NE(known, list.end()) << plan;
    for (const EffectParameter& parameter : effectById(known->known)->parameters)
      measurement.known.push_back({.effect = known->known,
                                   .parameter = std::string(parameter.name),
                                   .unit = std::string(parameter.unit),
                                   .value = 0,
                                   .sigma = 1e-3 * parameter.plausible});
    EXPECT_NEAR(attainableBy(measurement)[0].expanded / known->expanded, 1, 0.01) << plan << known->known;
  }
}

TEST(Attainable, OffersWhatIsWorthItTheLeastFirst) {
  for (const char* plan : {"paper", "paper-slider", "two-face", "full", "again"}) {
    const auto list = attainableBy(cleanBy(plan));
    ASSERT_FALSE(list.empty()) << plan;
    EXPECT_TRUE(std::is_sorted(list.begin() + 1, list.end(),
                               [](const auto& a, const auto& b) { return a.expanded < b.expanded; }));
    for (auto one = list.begin() + 1; one != list.end(); ++one) {
      EXPECT_LE(one->expanded, 0.9 * list[0].expanded) << plan;
      EXPECT_NE(one->known.empty(), one->measures.empty()) << plan;
    }
  }
}

// Noise five times as large costs more, where effects are not all there is.
TEST(Attainable, HasTheNoiseThatWasFound) {
  Truth truth = drawTruth(4);
  const Protocol& plan = *protocolByName("full");
  const double quiet = diagnosisOf(*examine(*simulate(plan, truth, 4)).measurement).attainable[0].expanded;
  truth.noiseFactor = 5;
  EXPECT_GT(diagnosisOf(*examine(*simulate(plan, truth, 4)).measurement).attainable[0].expanded, 1.2 * quiet);
}

TEST(Attainable, IsNotThereForOnePositionOrManyRows) {
  Measurement one = cleanBy("paper");
  one.arcs.pop_back();
  EXPECT_TRUE(attainableBy(one).empty());
  EXPECT_TRUE(attainableBy(*examine(test::largeSession(5100)).measurement).empty());
}

}  // namespace
}  // namespace alidade
