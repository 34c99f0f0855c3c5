#include "core/simulation/blind_trial.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/effects/catalogue.h"
#include "core/session/session_file.h"

namespace alidade {
namespace {

using testing::HasSubstr;

TEST(BlindTrial, RepeatsItselfForASeed) {
  const BlindTrial first = *drawBlindTrial({}, 7), again = *drawBlindTrial({}, 7),
                   other = *drawBlindTrial({}, 8);
  EXPECT_EQ(writeSession(first.session), writeSession(again.session));
  EXPECT_EQ(first.seal.kind, again.seal.kind);
  EXPECT_NE(writeSession(first.session), writeSession(other.session));
}

TEST(BlindTrial, ShowsAsFarAsAskedOrIsAsLargeAsItMayBe) {
  const BlindTrialOptions options{
      .protocol = "full", .leastVisible = 9, .mostVisible = 12, .mostPlausible = 4};
  for (const char* kind :
       {"collimation", "plane_tilt", "arc_ellipticity", "slider_scale", "vertical_axis_tilt"})
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      BlindTrialOptions one = options;
      one.kinds = {kind};
      const BlindTrial trial = *drawBlindTrial(one, seed);
      SCOPED_TRACE(kind);
      EXPECT_EQ(trial.seal.kind, kind);
      double square = 0;
      for (const TrueSize& size : trial.truth.effects)
        for (const EffectParameter& parameter : effectById(kind)->parameters)
          if (parameter.term == size.term) square += std::pow(size.value / parameter.plausible, 2);
      EXPECT_LE(std::sqrt(square), 4 * (1 + 1e-12));
      EXPECT_LT(*trial.seal.visible, 12.1);  // to 0.2 %, the tolerance of the size search
      if (std::sqrt(square) < 3.99) {
        EXPECT_GT(*trial.seal.visible, 8.9);
      }
    }
}

TEST(BlindTrial, GivesNothingAwayInTheSession) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    const BlindTrial trial = *drawBlindTrial({}, seed);
    const std::string text = writeSession(trial.session);
    for (const TrialKind& kind : trialKinds())
      EXPECT_EQ(text.find(kind.name), std::string::npos) << kind.name;
    EXPECT_TRUE(examine(trial.session).problems.empty());
  }
}

// Every kind occurs as often as stated: a share p of n draws has σ = √(p(1 − p)/n); 4.5 σ for each of some 24
// kinds. The slider's effects are drawn only if the slider is read.
TEST(BlindTrial, DrawsEveryKindAsOftenAsStated) {
  constexpr int count = 250;
  std::map<std::string, int> drawn;
  for (int seed = 1; seed <= count; ++seed) {
    const SealedTruth seal =
        drawBlindTrial({.protocol = "paper-slider"}, static_cast<std::uint64_t>(seed))->seal;
    ++drawn[seal.kind.starts_with("unknown") ? "unknown" : seal.kind];
  }
  double sum = 0;
  for (const TrialKind& kind : trialKinds()) {
    sum += kind.weight;
    EXPECT_NEAR(drawn[kind.name], count * kind.weight, 4.5 * std::sqrt(count * kind.weight)) << kind.name;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_EQ(drawn.size(), trialKinds().size());
}

TEST(BlindTrial, DrawsNoSliderEffectWithoutSlider) {
  const BlindTrialOptions options{.protocol = "paper", .kinds = {"slider_scale", "collimation"}};
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    EXPECT_EQ(drawBlindTrial(options, seed)->seal.kind, "collimation");
  EXPECT_THAT(drawBlindTrial({.protocol = "paper", .kinds = {"slider_scale"}}, 1).problem().text(),
              HasSubstr("shows none"));
}

// Two different effects, separable from each other and from all others if the protocol allows it.
TEST(BlindTrial, PutsTwoEffectsWhereTwoAreAskedFor) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const BlindTrial trial = *drawBlindTrial({.protocol = "full", .kinds = {"two_causes"}}, seed);
    EXPECT_EQ(trial.seal.kind, "two_causes");
    ASSERT_EQ(trial.seal.causes.size(), 2u);
    EXPECT_NE(trial.seal.causes.front(), trial.seal.causes.back());
  }
}

std::shared_ptr<const OwnEffects> ownEffects() {
  std::vector<Problem> problems;
  auto own = examineOwnEffects(
      {{.id = "dent",
        .formula = "radial = A*bump(s, 83°, 8°)",
        .parameters = {{.name = "A", .plausible = "0.2"}}},
       {.id = "three",
        .formula = "radial = A*cos(7*s)\nx = B*leg\nz = C*cos(5*s)",
        .parameters = {{.name = "A", .plausible = "0.2"},
                       {.name = "B", .plausible = "0.2"},
                       {.name = "C", .plausible = "0.2"}}},
       {.id = "scale", .formula = "slider = A*sin(3*s)", .parameters = {{.name = "A", .plausible = "20"}}}},
      problems);
  EXPECT_TRUE(problems.empty());
  return own;
}

// An own effect is drawn with all its amplitudes and known to the session, which does not reveal the truth.
TEST(BlindTrial, DrawsOwnEffects) {
  for (const auto& [id, amplitudes] : {std::pair("own:dent", 1u), std::pair("own:three", 3u)}) {
    const BlindTrialOptions options{
        .protocol = "full", .leastVisible = 9, .mostVisible = 12, .kinds = {id}, .own = ownEffects()};
    const BlindTrial trial = *drawBlindTrial(options, 3);
    EXPECT_EQ(trial.seal.kind, id);
    EXPECT_EQ(trial.truth.effects.size(), amplitudes);
    EXPECT_EQ(trial.session.ownEffects.size(), 3u);
    ASSERT_TRUE(trial.seal.visible);
    EXPECT_GT(*trial.seal.visible, 8.9);  // to 0.2 %, the tolerance of the size search
    EXPECT_LT(*trial.seal.visible, 12.1);
    EXPECT_TRUE(trial.seal.statesOwn);
  }
}

// Own effects are drawn as often as catalogued ones (4.5 σ of the count); the slider's need its readings.
TEST(BlindTrial, DrawsOwnEffectsAsOftenAsOthers) {
  constexpr int count = 200;
  const BlindTrialOptions options{.protocol = "paper", .own = ownEffects()};
  std::map<std::string, int> drawn;
  for (std::uint64_t seed = 1; seed <= count; ++seed) ++drawn[drawBlindTrial(options, seed)->seal.kind];
  EXPECT_EQ(drawn.count("own:scale"), 0u);
  const double expected = count * trialKinds().back().weight;
  for (const char* id : {"own:dent", "own:three"})
    EXPECT_NEAR(drawn[id], expected, 4.5 * std::sqrt(expected)) << id;
}

TEST(BlindTrial, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(drawBlindTrial({.protocol = "by-ear"}, 1).problem().text(), HasSubstr("by-ear"));
  EXPECT_THAT(drawBlindTrial({.protocol = "paper", .kinds = {"moonlight"}}, 1).problem().text(),
              HasSubstr("moonlight"));
}

}  // namespace
}  // namespace alidade
