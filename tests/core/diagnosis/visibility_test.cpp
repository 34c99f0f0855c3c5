#include "core/diagnosis/visibility.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/diagnosis/gap/gap_model.h"
#include "core/simulation/simulate.h"
#include "tests/support/trial_truth.h"

namespace alidade {
namespace {

/// False for the effects that the ray tracer lacks.
bool isKnownToTheRayTracer(const std::string& effect) {
  return effect != "plane_skew" && effect != "arm_sag" && effect != "vertical_graduation" &&
         effect != "vertical_refraction";
}

Visibility visibilityOfTrial(const test::Trial& trial) {
  Truth truth = test::truthOf(trial);
  truth.horizontalZero = trial.measurement.arcs[0].zeroHorizontal;
  const Result<Session> perfect = simulateWithoutNoise(*protocolByName(trial.protocol), truth, 1);
  return visibilityIn(*modelOf(*examine(*perfect).measurement), trial.kind);
}

// The ray tracer's own tools computed the visibility of each effect and its look-alikes. Its places differ
// from ours by some 60″, its figures are rounded, and it treats a plane tilt as linear: 3 %. Its fit leaves
// the distance free, which absorbs parts of the guideway's form and of slow changes; our fit uses the stated
// distance. So its visibilities do not exceed ours, and only effects that a distance does not absorb are
// compared. Look-alikes near the limit are not compared.
TEST(Visibility, AgreesWithTheRayTracer) {
  constexpr double clearlyInside = 3.5;
  const std::set<std::string> apartFromDistance{"collimation", "trunnion_tilt", "vertical_index",
                                                "vertical_circle_eccentricity", "slider_eccentricity"};
  int count = 0, alike = 0;
  for (const test::Trial& trial : test::trials()) {
    if (std::isinf(trial.visibleSigma)) continue;
    SCOPED_TRACE(trial.id + " " + trial.kind + " " + trial.protocol);
    const Visibility visibility = visibilityOfTrial(trial);
    const double tolerance = 0.03 * trial.visibleSigma + 0.1;
    EXPECT_GT(visibility.sigma, trial.visibleSigma - tolerance);
    if (apartFromDistance.contains(trial.kind)) {
      EXPECT_NEAR(visibility.sigma, trial.visibleSigma, tolerance);
      ++count;
    }
    for (const LookAlike& other : visibility.lookAlikes)
      if (other.difference < clearlyInside && trial.visibleSigma >= 6) {
        if (!isKnownToTheRayTracer(other.effect)) continue;
        EXPECT_TRUE(trial.lookAlikes.contains(other.effect)) << other.effect;
        ++alike;
      }
  }
  EXPECT_GE(count, 6);
  EXPECT_GE(alike, 5);
}

// The ray tracer's own tools computed the visibility with closures. Its places differ from ours by some 60″.
// Its free distance absorbs parts of a tilt and a warp, which are therefore at least as visible here.
TEST(Visibility, CountsWhatThePositionsMustAgreeOn) {
  const std::set<std::string> apartFromDistance{"plane_offset", "radius_change", "axial_shift",
                                                "orientation_jump"};
  int compared = 0;
  for (const test::Trial& trial : test::closureTrials()) {
    if (trial.kind == "none" || trial.truth.at("reference") == true) continue;
    SCOPED_TRACE(trial.id + " " + trial.kind + " " + trial.protocol);
    Truth truth = test::truthOf(trial);
    truth.horizontalZero = trial.measurement.arcs[0].zeroHorizontal;
    const Result<Session> perfect = simulateWithoutNoise(*protocolByName(trial.protocol), truth, 1);
    const Visibility visibility = *visibilityOf(*examine(*perfect).measurement, trial.kind);
    const double tolerance = 0.05 * trial.visibleSigma + 0.1;
    EXPECT_GT(visibility.sigma, trial.visibleSigma - tolerance);
    if (!apartFromDistance.contains(trial.kind)) continue;
    EXPECT_NEAR(visibility.sigma, trial.visibleSigma, tolerance);
    ++compared;
  }
  EXPECT_GE(compared, 16);
}

TEST(Visibility, IsNothingWithoutAnEffect) {
  const Result<Session> perfect = simulateWithoutNoise(*protocolByName("full"), drawTruth(5), 5);
  const Visibility visibility = *visibilityOf(*examine(*perfect).measurement, "collimation");
  EXPECT_LT(visibility.sigma, 1e-3);  // readings are rounded to 1e-6″
}

TEST(Visibility, FailsInWordsWithoutReadings) {
  Measurement empty = test::paperMeasurement();
  empty.arcs.clear();
  EXPECT_FALSE(visibilityOf(empty, "collimation"));
}

}  // namespace
}  // namespace alidade
