#include "core/diagnosis/conclusion/linear_move.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/search/explained_model.h"
#include "core/effects/catalogue.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

/// So that the pause between the positions is known, which the linear moves leave out.
Measurement withTimes(Measurement measurement) {
  for (ArcMeasurement& arc : measurement.arcs)
    for (Sighting& sighting : arc.sightings) sighting.minutes = static_cast<double>(sighting.sequence);
  setMoments(measurement);
  return measurement;
}

// Beside a fit of the whole model with the explanation's causes. The equations at the fit that the causes
// have spoiled are wrong by some thousandths, so a move of forty σ by a fifth of σ. Larger noise also shifts
// the weights between readings and zeros, which the equations have as stated: 5 % of σ.
TEST(LinearMoves, AgreeWithAFitOfTheWholeModel) {
  int compared = 0, moved = 0;
  for (const test::Trial& trial : test::trials()) {
    const Measurement measurement = withTimes(trial.measurement);
    const Inquiry inquiry = inquire(*modelOf(measurement), {}, {});
    if (!inquiry.largeGrossErrors.empty()) continue;
    LinearMoves moves(inquiry);
    for (const Explanation& explanation : inquiry.explanations) {
      if (explanation.shaped || explanation.chance < 0.01) continue;
      const std::optional<Move> move = moves.of(explanation);
      if (!move) continue;
      // Larger noise weighs the readings less against the zeros, with or without causes.
      Explanation nothing;
      nothing.noisy = explanation.noisy;
      nothing.noise = explanation.noise;
      const auto before = estimateOf(modelWith(inquiry.base, nothing, inquiry.candidates, inquiry.leftover));
      ASSERT_TRUE(before);
      const double byNothing = moves.of(nothing)->variance;
      const auto fitted =
          estimateOf(modelWith(inquiry.base, explanation, inquiry.candidates, inquiry.leftover));
      const double shift = fitted->value - before->value;
      EXPECT_NEAR(move->shift, shift, 0.1 * fitted->sigma + 0.01 * std::abs(shift)) << trial.id;
      const double variance = before->sigma * before->sigma + move->variance - byNothing;
      // Zeros do not scatter as the readings do where these leave much.
      if (noiseScale(*inquiry.base.fit).factor < 2) {
        EXPECT_NEAR(std::sqrt(variance) / fitted->sigma, 1, 0.05) << trial.id;
      }
      ++compared;
      moved += std::abs(shift) > fitted->sigma;
    }
  }
  EXPECT_GT(compared, 50);
  EXPECT_GT(moved, 10);
}

// With every effect besides, beside a fit of it: the answer's parts are as wide there as here. Beside a
// misread value there is nothing to count from, since all scatters by it.
TEST(LinearMoves, AgreeWithAFitOfEveryEffect) {
  int compared = 0;
  for (const test::Trial& trial : test::trials()) {
    const Measurement measurement = withTimes(trial.measurement);
    const Inquiry inquiry = inquire(*modelOf(measurement), {}, {});
    if (!inquiry.largeGrossErrors.empty()) continue;
    LinearMoves moves(inquiry, Besides::EveryEffect);
    EXPECT_EQ(moves.effects().size() + inquiry.base.options.terms.size(),
              everyEffect(*inquiry.base.measurement).size());
    const auto base = estimateOf(withEveryEffect(inquiry.base));
    const Move ofNothing = *moves.of({});
    const auto isReading = [&](const Part& part) { return inquiry.of(part).grossErrorAt().has_value(); };
    for (const Explanation& explanation : inquiry.explanations) {
      if (explanation.shaped || explanation.noisy || explanation.chance < 0.01 ||
          std::ranges::any_of(explanation.parts, isReading))
        continue;
      const std::optional<Move> move = moves.of(explanation);
      if (!move) continue;
      const auto fitted = estimateOf(
          withEveryEffect(modelWith(inquiry.base, explanation, inquiry.candidates, inquiry.leftover)));
      const double shift = fitted->value - base->value;
      EXPECT_NEAR(move->shift - ofNothing.shift, shift, 0.1 * fitted->sigma + 0.02 * std::abs(shift))
          << trial.id;
      const double variance = base->sigma * base->sigma + move->variance - ofNothing.variance;
      if (noiseScale(*inquiry.base.fit).factor < 2) {
        EXPECT_NEAR(std::sqrt(variance) / fitted->sigma, 1, 0.1) << trial.id;
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 50);
}

// Readings that hold every effect as large as it may be speak for that, and perfect ones against it.
TEST(LinearMoves, WeighWhatIsThereBesides) {
  const auto weighed = [](const Session& session) {
    const Inquiry inquiry = inquire(*modelOf(*examine(session).measurement), {}, {});
    return *LinearMoves(inquiry, Besides::EveryEffect).logEvidenceOfEffects({});
  };
  Truth truth = drawTruth(8);
  const Protocol& protocol = *protocolByName("two-face");
  EXPECT_LT(weighed(*simulateWithoutNoise(protocol, truth, 8)), -3);
  for (const Effect& effect : effectCatalogue())
    if (effect.response != Response::AllOrNothing)
      for (const EffectParameter& parameter : effect.parameters)
        truth.effects.push_back({parameter.term, parameter.plausible});
  EXPECT_GT(weighed(*simulate(protocol, truth, 8)), 100);
}

}  // namespace
}  // namespace alidade
