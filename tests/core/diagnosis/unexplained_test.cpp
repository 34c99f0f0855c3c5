#include "core/diagnosis/conclusion/unexplained.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random_source.h"
#include "core/diagnosis/diagnose.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

// exp((z² − 1)/2)/z is 41.36 at the two-sided risk of 0.1 %, z = 3.2905.
TEST(Unexplained, WeighsAMisclosureByItsChance) {
  EXPECT_NEAR(chanceOfMore(1e-3), 0.5, 1e-12);
  EXPECT_NEAR(chanceOfMore(1), 1 / (1 + 41.36), 1e-4);
  EXPECT_NEAR(chanceOfMore(0.5), 1 / (1 + 41.36), 1e-4) << "less than 1σ";
  EXPECT_EQ(chanceOfMore(0), 1);
  const double z = 4, chance = 6.334e-5;  // two-sided probability of a normal variable beyond z
  EXPECT_NEAR(chanceOfMore(chance), 1 / (1 + 41.36 / (std::exp((z * z - 1) / 2) / z)), 1e-3);
}

// From a risk of 100 % to 1e-12 in steps of 2 %: the result never changes by more than z does in a step.
TEST(Unexplained, NeverJumps) {
  double before = chanceOfMore(1);
  for (double chance = 1; chance > 1e-12; chance *= 0.98) {
    const double now = chanceOfMore(chance);
    EXPECT_GE(now, before - 1e-12) << chance;
    EXPECT_LT(now - before, 0.01) << chance;
    before = now;
  }
}

Diagnosis diagnosisOf(const Truth& truth, std::uint64_t seed) {
  return *diagnose(*examine(*simulate(*protocolByName("paper"), truth, seed)).measurement);
}

TEST(Unexplained, IsLittleWhereNothingIsWrongAndAllWhereNothingFits) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Truth truth = drawTruth(seed);
    const Diagnosis sound = diagnosisOf(truth, seed);
    EXPECT_LT(sound.unexplained.chance, 0.3) << seed;
    EXPECT_LT(sound.unexplained.sigma, 0.2 * sound.measured->estimate.sigma) << seed;
    truth.harmonic = FormHarmonic{.order = 7, .cosine = 0.2, .sine = 0.1};  // not an effect of the catalogue
    const Diagnosis strange = diagnosisOf(truth, seed);
    EXPECT_EQ(strange.verdict, DiagnosisVerdict::NotInCatalogue) << seed;
    EXPECT_GT(strange.unexplained.chance, 0.9) << seed;
  }
}

// 3 mm of axial shift is fifteen plausible sizes. With every effect that changes x excluded, Δx stays open,
// and half of its misclosure enters Δd.
TEST(Unexplained, PutsAnOpenClosureIntoTheUncertainty) {
  Truth truth = drawTruth(3);
  truth.effects = {{ErrorTerm::AxialShift, 3}};
  const Measurement measurement = *examine(*simulate(*protocolByName("paper"), truth, 3)).measurement;
  const Diagnosis explained = *diagnose(measurement);
  EXPECT_LT(explained.unexplained.sigma, 0.05);
  const Diagnosis open =
      *diagnose(measurement, {.without = {"axial_shift", "plane_skew", "horizontal_drift", "vertical_drift",
                                          "orientation_jump", "setup_shift", "underestimated_noise"}});
  EXPECT_GT(open.unexplained.chance, 0.5);
}

// In one face a zero and all readings after it may be turned vertically, in either position, without a trace.
// 60″ over 2405 mm are 0.70 mm in one position and 0.35 mm in Δd; the other component is equal.
TEST(UndetectableJumps, AreThoseBetweenZeroAndFirstSighting) {
  const Diagnosis diagnosis = *diagnose(test::paperMeasurement());
  ASSERT_EQ(diagnosis.undetectableJumps.size(), 2U);
  for (const UndetectableJump& jump : diagnosis.undetectableJumps) {
    EXPECT_TRUE(jump.isAfterZero);
    EXPECT_NEAR(jump.influence, 2405 * 60 / 206265.0 / 2, 0.02);
    ASSERT_EQ(jump.moves.size(), 2U);
    EXPECT_NEAR(jump.moves[0].share + jump.moves[1].share, PriorOdds{}.wrongZero / 4, 1e-12)
        << "the other moments would show";
    EXPECT_NEAR(jump.moves[0].sigma, 0.3 * jump.influence, 1e-12);
    EXPECT_NEAR(jump.moves[1].sigma, jump.influence, 1e-12);
  }
  EXPECT_EQ(diagnosis.undetectableJumps[0].axisDeg, 0);
  EXPECT_EQ(diagnosis.undetectableJumps[1].axisDeg, 180);
}

}  // namespace
}  // namespace alidade
