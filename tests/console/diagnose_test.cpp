#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/console/console.h"

namespace alidade::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json diagnosisOf(const std::vector<std::string>& arguments) {
  std::vector<std::string> call{"diagnose", "--json"};
  call.insert(call.end(), arguments.begin(), arguments.end());
  const ProgramRun outcome = alidadeCli(call);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  return json::parse(outcome.out);
}

const std::string trials = ALIDADE_REFERENCE_DIR "/trials/sessions/";

TEST(Diagnose, AnswersWithTheKeysOfTheContract) {
  const json answer = diagnosisOf({paperSession, "--vertical-angle", "planar"});
  EXPECT_EQ(answer.at("session"), "Table I");
  EXPECT_EQ(answer.at("verdict"), "several-causes");
  EXPECT_EQ(answer.at("causes").at(0).at("effect"), "vertical_angle_relation");
  for (const char* key : {"effect", "probability", "parameters", "indistinguishable_from", "readings"})
    EXPECT_TRUE(answer.at("causes").at(0).contains(key)) << key;
  for (const char* when : {"gap", "after"})
    for (const char* key : {"rms_arcsec", "reduced_chi2", "p_value"})
      EXPECT_TRUE(answer.at(when).at(key).is_number()) << when << " " << key;
  for (const char* key : {"in_sample", "of_excess", "held_out"})
    EXPECT_TRUE(answer.at("shrink").at(key).is_number()) << key;
  EXPECT_GT(answer.at("shrink").at("held_out").get<double>(), 0.5);
  for (const char* when : {"before", "after"})
    EXPECT_TRUE(answer.at("intersection").at(when).at("value_mm").is_number());
  for (const char* key : {"candidates", "where", "unseen", "advice"})
    EXPECT_FALSE(answer.at(key).empty()) << key;
  EXPECT_NEAR(answer.at("gap").at("reduced_chi2").get<double>(), 580.23, 0.01);  // the planar fit's own χ²
}

TEST(Diagnose, NamesTheCellsOfAMisreading) {
  const json answer = diagnosisOf({trials + "491556.alidade"});
  const json& cell = answer.at("causes").at(0).at("readings").at(0);
  EXPECT_EQ(cell.at("axis_deg"), 0);
  EXPECT_EQ(cell.at("round"), 1);
  EXPECT_EQ(cell.at("point"), 11);
  EXPECT_EQ(cell.at("face"), 1);
  EXPECT_EQ(cell.at("circle"), "vertical");
}

TEST(Diagnose, LeavesEffectsOutThatAreNotToBeConsidered) {
  const json answer = diagnosisOf({trials + "341903.alidade", "--without", "arc_ellipticity"});
  for (const json& cause : answer.at("causes")) EXPECT_NE(cause.at("effect"), "arc_ellipticity");
  for (const json& candidate : answer.at("candidates")) EXPECT_NE(candidate.at("effect"), "arc_ellipticity");
}

TEST(Diagnose, SaysItInWordsToo) {
  const ProgramRun outcome = alidadeCli({"diagnose", trials + "293018.alidade"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_THAT(outcome.out, HasSubstr("Cause: collimation"));
  EXPECT_THAT(outcome.out, HasSubstr("cannot tell it from: horizontal_circle_eccentricity"));
}

TEST(Diagnose, RefusesAnEffectThatDoesNotExist) {
  const ProgramRun outcome = alidadeCli({"diagnose", paperSession, "--without", "gremlins"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_THAT(outcome.err, HasSubstr("gremlins"));
}

}  // namespace
}  // namespace alidade::test
