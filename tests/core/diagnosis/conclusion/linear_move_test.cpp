#include "core/diagnosis/conclusion/linear_move.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/search/explained_model.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

// The reference is a fit of the whole model with the causes of the explanation. The causes distort the fit at
// which the equations were linearised by some thousandths: a move of forty σ errs by a fifth of σ. Larger
// noise also changes the weights between readings and zeros, which the equations have as stated: 5 % of σ.
TEST(LinearMoves, AgreeWithAFitOfTheWholeModel) {
  int compared = 0, moved = 0;
  for (const test::Trial& trial : test::trials()) {
    const Measurement measurement = test::withTimes(trial.measurement);
    const Inquiry inquiry = inquire(*modelOf(measurement), {}, {});
    if (!inquiry.excluded.empty()) continue;
    LinearMoves moves(inquiry);
    for (const Explanation& explanation : inquiry.explanations) {
      if (explanation.shaped || explanation.chance < 0.01) continue;
      const std::optional<Move> move = moves.of(explanation);
      if (!move) continue;
      // Larger noise reduces the weight of readings relative to zeros, with or without causes.
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
      // If the readings have a large misfit, zeros do not scatter like them.
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

}  // namespace
}  // namespace alidade
