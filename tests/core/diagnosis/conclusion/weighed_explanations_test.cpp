#include "core/diagnosis/conclusion/weighed_explanations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/diagnosis/conclusion/answer.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/search/explained_model.h"
#include "core/effects/catalogue.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

constexpr EffectScales asPlausible;

// The reference is a fit of every effect, in which the parts of the answer have the same widths. Sessions
// with a misread value are excluded, because everything scatters by it.
TEST(Accounts, AgreeWithAFitOfEveryEffect) {
  int compared = 0;
  for (const test::Trial& trial : test::trials()) {
    const Inquiry inquiry = inquire(*modelOf(test::withTimes(trial.measurement)), {}, {});
    if (!inquiry.excluded.empty()) continue;
    WeighedExplanations weighed(inquiry);
    EXPECT_EQ(weighed.effects().size() + inquiry.base.options.terms.size(),
              everyEffect(trial.measurement).size());
    const auto base = estimateOf(withEveryEffect(inquiry.base));
    const WeighedExplanation ofNothing = *weighed.of({}, asPlausible);
    const auto isReading = [&](const Part& part) { return inquiry.of(part).grossErrorAt().has_value(); };
    const auto isBent = [&](const Part& part) { return inquiry.of(part).response() != Response::Linear; };
    for (const Explanation& explanation : inquiry.explanations) {
      if (explanation.shaped || explanation.noisy || explanation.chance < 0.01 ||
          std::ranges::any_of(explanation.parts, isReading) || std::ranges::any_of(explanation.parts, isBent))
        continue;
      const std::optional<WeighedExplanation> one = weighed.of(explanation, asPlausible);
      ASSERT_TRUE(one) << trial.id;
      const auto fitted = estimateOf(
          withEveryEffect(modelWith(inquiry.base, explanation, inquiry.candidates, inquiry.leftover)));
      const double shift = fitted->value - base->value;
      EXPECT_NEAR(one->value - ofNothing.value, shift, 0.05 * fitted->sigma + 0.02 * std::abs(shift))
          << trial.id;
      const double variance = base->sigma * base->sigma + one->variance - ofNothing.variance;
      // If the readings have a large misfit, zeros do not scatter like them.
      if (noiseScale(*inquiry.base.fit).factor < 2) {
        EXPECT_NEAR(std::sqrt(variance) / fitted->sigma, 1, 0.1) << trial.id;
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 50);
}

// Without other effects an explanation of known widths has the evidence that the search found. It sums over
// widths of which the most likely has at least a quarter: ln 4 for each part.
TEST(Accounts, HaveTheEvidenceOfTheSearch) {
  int compared = 0;
  for (const test::Trial& trial : test::trials()) {
    const Inquiry inquiry = inquire(*modelOf(test::withTimes(trial.measurement)), {}, {});
    WeighedExplanations weighed(inquiry);
    const double nothing = weighed.of({}, noEffect)->logOdds;
    for (const Explanation& explanation : inquiry.explanations) {
      const auto isPlain = [&](const Part& part) {
        const Component& component = inquiry.of(part);
        return component.isEffect() && component.response() == Response::Linear && !component.isKnown() &&
               part.width == component.widthOfFit(part.width, part.weights);
      };
      if (explanation.noisy || explanation.parts.empty() || !std::ranges::all_of(explanation.parts, isPlain))
        continue;
      const double difference =
          weighed.of(explanation, noEffect)->logOdds - nothing - explanation.logBayesFactor;
      EXPECT_NEAR(difference, 0, std::log(4.0) * static_cast<double>(explanation.parts.size()) + 0.1)
          << trial.id;
      ++compared;
    }
  }
  EXPECT_GT(compared, 30);
}

Session sessionWith(const char* plan, double sizes) {
  Truth truth = drawTruth(8);
  for (const Effect& effect : effectCatalogue())
    if (effect.response != Response::AllOrNothing)
      for (const EffectParameter& parameter : effect.parameters)
        truth.effects.push_back({parameter.term, sizes * parameter.plausible});
  return *simulate(*protocolByName(plan), truth, 8);
}

EffectScales likeliestIn(const Session& session) {
  const Inquiry inquiry = inquire(*modelOf(*examine(session).measurement), {}, {});
  WeighedExplanations weighed(inquiry);
  weighed.alsoAt(withEveryEffect(inquiry.base), {}, {});
  return std::ranges::max(weighed.of({}), {}, &WeighedExplanation::logOdds).scales;
}

// The readings determine the common scale of the effects.
TEST(Accounts, FindHowLargeTheEffectsAre) {
  EXPECT_EQ(likeliestIn(sessionWith("full", 0)), asPlausible);
  EXPECT_EQ(likeliestIn(sessionWith("full", 1)), asPlausible);
  EXPECT_EQ(likeliestIn(sessionWith("full", 3)), (EffectScales{3, 3, 3}));
}

// A pattern exceeds all effects of plausible size; several causes beyond separation do not.
TEST(Accounts, TellManyCausesFromAPattern) {
  const auto answerOf = [](const Session& session) {
    return conclude(inquire(*modelOf(*examine(session).measurement), {}, {})).kind;
  };
  EXPECT_EQ(answerOf(sessionWith("full", 1)), Answer::Kind::Several);
  EXPECT_EQ(answerOf(sessionWith("two-face", 1)), Answer::Kind::Several);
  Truth truth = drawTruth(8);
  truth.harmonic = FormHarmonic{7, 0.2, 0.1};
  EXPECT_EQ(answerOf(*simulate(*protocolByName("full"), truth, 8)), Answer::Kind::Unknown);
}

}  // namespace
}  // namespace alidade
