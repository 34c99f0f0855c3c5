#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/console/console.h"

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

Json diagnosisOf(const std::vector<std::string>& arguments) {
  std::vector<std::string> call{"diagnose", "--json"};
  call.insert(call.end(), arguments.begin(), arguments.end());
  const ProgramRun outcome = alidadeCli(call);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  return Json::parse(outcome.out);
}

const std::string trials = ALIDADE_REFERENCE_DIR "/trials/sessions/";

TEST(Diagnose, AnswersWithTheKeysOfTheContract) {
  const Json answer = diagnosisOf({paperSession, "--vertical-angle", "planar"});
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
  for (const char* key : {"candidates", "where", "unseen", "advice", "attainable"})
    EXPECT_FALSE(answer.at(key).empty()) << key;
  EXPECT_NEAR(answer.at("gap").at("reduced_chi2").get<double>(), 580.23, 0.01);  // χ² of the planar fit
}

TEST(Diagnose, NamesTheCellsOfAMisreading) {
  const Json answer = diagnosisOf({trials + "491556.alidade"});
  const Json& cell = answer.at("causes").at(0).at("readings").at(0);
  EXPECT_EQ(cell.at("axis_deg"), 0);
  EXPECT_EQ(cell.at("round"), 1);
  EXPECT_EQ(cell.at("point"), 11);
  EXPECT_EQ(cell.at("face"), 1);
  EXPECT_EQ(cell.at("circle"), "vertical");
}

TEST(Diagnose, LeavesEffectsOutThatAreNotToBeConsidered) {
  const Json answer = diagnosisOf({trials + "341903.alidade", "--without", "arc_ellipticity"});
  for (const Json& cause : answer.at("causes")) EXPECT_NE(cause.at("effect"), "arc_ellipticity");
  for (const Json& candidate : answer.at("candidates")) EXPECT_NE(candidate.at("effect"), "arc_ellipticity");
}

TEST(Diagnose, SaysItInWordsToo) {
  const ProgramRun outcome = alidadeCli({"diagnose", trials + "293018.alidade"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_THAT(outcome.out, HasSubstr("Collimation  "));
  EXPECT_THAT(outcome.out, HasSubstr("indistinguishable: horizontal circle eccentricity"));
}

// 600″ is 300 σ: such misread values are excluded before the search, and still reported everywhere.
TEST(Diagnose, TellsAMisreadValueThatIsFarOff) {
  const std::string sample = ALIDADE_SAMPLES_DIR "/misreading.alidade";
  const Json answer = diagnosisOf({sample});
  const Json& candidates = answer.at("candidates");
  EXPECT_EQ(candidates.at(0).at("effect"), "gross_error");
  EXPECT_EQ(answer.at("steps").at(0).at("effect"), "gross_error");
  EXPECT_GT(answer.at("shrink").at("held_out").get<double>(), 0.9);
  const auto readings = std::ranges::find(answer.at("where"), "readings",
                                          [](const Json& part) { return part.at("of").get<std::string>(); });
  ASSERT_NE(readings, answer.at("where").end());
  EXPECT_GT(readings->at("share").get<double>(), 0.95);
  const std::string text = alidadeCli({"diagnose", sample}).out;
  EXPECT_THAT(text, HasSubstr("belongs to: readings (100 %)\n"));
  EXPECT_THAT(text, Not(HasSubstr("\nface: "))) << "one face was read";
  EXPECT_THAT(text, HasSubstr("axis at: 0° ("));
}

TEST(Diagnose, TellsWhereTheModelHoldsBesideAForm) {
  const std::string dent = ALIDADE_SAMPLES_DIR "/dented-guideway.alidade";
  EXPECT_THAT(alidadeCli({"diagnose", dent}).out, HasSubstr("The model holds where s is within 10°…2"));
  const std::string harmonic = ALIDADE_SAMPLES_DIR "/unknown-form.alidade";
  EXPECT_THAT(alidadeCli({"diagnose", harmonic}).out, Not(HasSubstr("The model holds")));
}

std::string changedFile(const TemporaryFolder& folder, const std::function<void(Json&)>& change) {
  return folder.file("changed.alidade", changedPaperSession(change));
}

/// Keeps `count` evenly spread places of the position.
void keepPlaces(Json& session, std::size_t position, std::size_t count) {
  auto& readings = session["positions"][position]["readings"];
  Json few = Json::array();
  for (std::size_t i = 0; i < count; ++i) few.push_back(readings[i * (readings.size() - 1) / (count - 1)]);
  readings = few;
}

TEST(Diagnose, SaysWhereNothingChecksTheModel) {
  const TemporaryFolder folder;
  const std::string file = changedFile(folder, [](Json& session) {
    session["positions"].erase(1);  // otherwise the positions would check one another
    keepPlaces(session, 0, 3);
  });
  const Json answer = diagnosisOf({file});
  for (const char* when : {"gap", "after"})
    for (const char* key : {"reduced_chi2", "p_value"}) EXPECT_TRUE(answer.at(when).at(key).is_null()) << key;
  const std::string text = alidadeCli({"diagnose", file}).out;
  EXPECT_THAT(text, HasSubstr("Nothing checks the model"));
  EXPECT_THAT(text, testing::Not(HasSubstr("nan")));
}

TEST(Diagnose, RefusesAPositionThatFixesNoCircle) {
  const TemporaryFolder folder;
  const std::string file = changedFile(folder, [](Json& session) { keepPlaces(session, 0, 2); });
  for (const char* command : {"diagnose", "plan"}) {
    const ProgramRun run = alidadeCli({command, file});
    expectRefusal(run);
    EXPECT_THAT(run.err, HasSubstr("positions[0].readings")) << command;
    EXPECT_EQ(run.err, alidadeCli({"fit", file}).err) << command;
  }
}

TEST(Diagnose, WarnsOfAnEffectOfTheModelThatIsNone) {
  const TemporaryFolder folder;
  const std::string file = changedFile(folder, [](Json& session) {
    session["model"]["effects"] = {"gremlins"};
    session["positions"].erase(1);
  });
  for (const char* command : {"diagnose", "plan"}) {
    const Json findings = Json::parse(alidadeCli({command, file, "--json"}).out).at("findings");
    const auto warns = [&](const std::string& text) {
      return std::ranges::any_of(findings, [&](const Json& finding) {
        return finding.at("text").get<std::string>().find(text) != std::string::npos;
      });
    };
    EXPECT_TRUE(warns("gremlins")) << command;
    EXPECT_TRUE(warns("180°")) << command << " misses a position";
    EXPECT_THAT(alidadeCli({command, file}).out, HasSubstr("Warning: model.effects:")) << command;
  }
}

TEST(Diagnose, RefusesANoiseThatNoCircleHas) {
  const TemporaryFolder folder;
  const std::string file =
      changedFile(folder, [](Json& session) { session["instrument"]["sigma_vertical_arcsec"] = 1e-9; });
  const ProgramRun run = alidadeCli({"diagnose", file});
  expectRefusal(run);
  EXPECT_THAT(run.err, HasSubstr("instrument.sigma_vertical_arcsec"));
  EXPECT_THAT(run.err, HasSubstr("at least 0.001"));
}

TEST(Diagnose, RefusesAnEffectThatDoesNotExist) {
  const ProgramRun outcome = alidadeCli({"diagnose", paperSession, "--without", "gremlins"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_THAT(outcome.err, HasSubstr("gremlins"));
}

/// An order is exact, an amplitude has its u; both without identifiers.
TEST(Discover, NamesTheNumbersOfAFormInWords) {
  std::string table = "residual_arcsec,sigma_arcsec,circle,azimuth_deg,elevation_deg\n";
  for (int i = 0; i < 90; ++i)
    table += std::to_string(8 * std::cos(4 * i * std::numbers::pi / 30)) + ",1,horizontal," +
             std::to_string(4 * i) + ",5\n";
  const TemporaryFolder folder;
  const std::string text = alidadeCli({"discover", folder.file("table.csv", table)}).out;
  EXPECT_THAT(text, HasSubstr("\n  order: 6\n"));
  EXPECT_THAT(text, HasSubstr("\n  amplitude: 7.99″ (u "));
  EXPECT_THAT(text, Not(HasSubstr("_arcsec")));
}

}  // namespace
}  // namespace alidade::test
