#include "core/simulation/truth_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/effects/catalogue.h"

namespace alidade {
namespace {

using testing::HasSubstr;

Truth with(const std::vector<std::string>& effects) {
  Truth truth;
  for (const std::string& effect : effects) {
    const auto problem = addEffect(truth, effect);
    EXPECT_FALSE(problem) << problem->what;
  }
  return truth;
}

std::string refusal(const std::string& effect) {
  Truth truth;
  const auto problem = addEffect(truth, effect);
  return problem ? problem->what : "";
}

nlohmann::json documentOf(const Truth& truth) {
  return nlohmann::json::parse(truthJson("17", truth)).at("17");
}

TEST(TruthText, TakesEveryEffectOfTheCatalogue) {
  for (const Effect& effect : effectCatalogue()) {
    std::string text = std::string(effect.id) + "=";
    for (std::size_t i = 0; i < effect.parameters.size(); ++i)
      text += (i ? ",0." : "0.") + std::to_string(i + 1);
    const Truth truth = with({text});
    ASSERT_EQ(truth.effects.size(), effect.parameters.size());
    for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
      EXPECT_EQ(truth.effects[i].term, effect.parameters[i].term);
      EXPECT_DOUBLE_EQ(truth.effects[i].value, 0.1 * static_cast<double>(i + 1));
    }
    EXPECT_EQ(documentOf(truth).at("kind"), effect.id);
    EXPECT_THAT(effectNames(), HasSubstr("  " + std::string(effect.id) + "="));
  }
}

TEST(TruthText, TakesOneOfSeveralSizes) {
  const Truth truth = with({"plane_tilt.y=0.2", "plane_tilt.x=-0.1", "plane_tilt.y=0.3"});
  ASSERT_EQ(truth.effects.size(), 2u);
  const nlohmann::json effects = documentOf(truth).at("effects");
  EXPECT_EQ(effects.at("plane_tilt.x"), -0.1);
  EXPECT_EQ(effects.at("plane_tilt.y"), 0.3);
}

TEST(TruthText, TakesWhatIsNoErrorTerm) {
  const Truth truth = with({"orientation_jump=0.4,30,-20", "gross_error=180,1,11,2,60,0",
                            "underestimated_noise=2.5", "form_harmonic=7,0.1,0.2"});
  ASSERT_TRUE(truth.jump && truth.harmonic);
  EXPECT_EQ(truth.jump->moment, 0.4);
  EXPECT_NEAR(truth.jump->vertical.arcseconds(), -20, 1e-12);
  EXPECT_EQ(truth.harmonic->order, 7);
  EXPECT_EQ(truth.noiseFactor, 2.5);
  const nlohmann::json json = documentOf(truth);
  EXPECT_EQ(json.at("kind"), "several_causes");
  EXPECT_EQ(json.at("causes"), (std::vector<std::string>{"orientation_jump", "gross_error",
                                                         "underestimated_noise", "unknown_harmonic"}));
  ASSERT_EQ(json.at("blunders").size(), 1u);
  EXPECT_EQ(json.at("blunders")[0][0], 1);
  EXPECT_NEAR(json.at("blunders")[0][4].get<double>(), 60, 1e-9);
  EXPECT_NEAR(json.at("true_sigma_arcsec").get<double>(), 5, 1e-9);
}

// 0 at 0°, 1 at 180°, 2 at 0° again: the position numbers of a truth file.
TEST(TruthText, TellsWhichPositionAtAnAxisIsMeant) {
  const Truth truth =
      with({"zero_slip=0,30,-40,2", "gross_error=180,1,11,1,60,0,2", "gross_error=0,1,3,1,0,60"});
  ASSERT_TRUE(truth.wrongZero);
  EXPECT_EQ(truth.wrongZero->repeat, 2);
  const nlohmann::json json = documentOf(truth);
  EXPECT_EQ(json.at("effects").at("zero_slip")[0], 2);
  EXPECT_EQ(json.at("blunders")[0][0], 3);
  EXPECT_EQ(json.at("blunders")[1][0], 0);
  EXPECT_THAT(refusal("zero_slip=0,30,-40,0"), HasSubstr("number of the position at that axis"));
  EXPECT_THAT(refusal("gross_error=0,1,3,1,0,60,1.5"), HasSubstr("number of the position at that axis"));
  for (const int number : {0, 1, 2, 3, 4}) {
    const auto [axisDeg, repeat] = NumberedPosition::of(number);
    EXPECT_EQ((NumberedPosition{axisDeg, repeat}.number()), number);
  }
}

TEST(TruthText, NamesTheKind) {
  EXPECT_EQ(documentOf({}).at("kind"), "none");
  for (const char* ofNoSize : {"collimation=0", "orientation_jump=0.4,0,0", "gross_error=180,1,11,1,0,0",
                               "form_harmonic=7,0,0", "local_dent=0,10,5"})
    EXPECT_EQ(documentOf(with({ofNoSize})).at("kind"), "none") << ofNoSize;
  EXPECT_EQ(documentOf(with({"collimation=5", "gravity_sag=0.1"})).at("kind"), "two_causes");
}

TEST(TruthText, RefusesInOneSentence) {
  EXPECT_THAT(refusal("collimation"), HasSubstr("NAME=VALUE"));
  EXPECT_THAT(refusal("moonlight=3"), HasSubstr("“moonlight” is no effect"));
  EXPECT_THAT(refusal("collimation=fast"), HasSubstr("“collimation”"));
  EXPECT_THAT(refusal("collimation="), HasSubstr("“collimation”"));
  EXPECT_THAT(refusal("plane_tilt=0.3"), HasSubstr("2 sizes, not 1"));
  EXPECT_THAT(refusal("collimation=1,2"), HasSubstr("1 size, not 2"));
  EXPECT_THAT(refusal("orientation_jump=1.5,3,4"), HasSubstr("moment"));
  EXPECT_THAT(refusal("gross_error=90,1,1,1,60,0"), HasSubstr("axis"));
  EXPECT_THAT(refusal("gross_error=0,1.5,1,1,60,0"), HasSubstr("axis"));
  EXPECT_THAT(refusal("underestimated_noise=-1"), HasSubstr("0 or more"));
  EXPECT_THAT(refusal("form_harmonic=0.5,1,1"), HasSubstr("order"));
}

}  // namespace
}  // namespace alidade
