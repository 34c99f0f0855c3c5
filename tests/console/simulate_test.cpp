#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/console/console.h"
#include "tests/support/file_content.h"

// `alidade-cli simulate`: a session for `fit`, and its truth in a separate file.

namespace alidade::test {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

class SimulateTest : public ::testing::Test {
 protected:
  ProgramRun simulate(std::vector<std::string> more) const {
    more.insert(more.begin(), {"simulate", "--out", session, "--truth", truth});
    return alidadeCli(std::move(more));
  }

  TemporaryFolder folder;
  std::string session = (folder.path() / "s1.alidade").string(), truth = (folder.path() / "t.json").string();
};

// Δd of the file's fit is within 5 σ of the truth, some 0.1 mm at 2″, for a drawn Δd of up to 3 mm.
TEST_F(SimulateTest, WritesASessionAndItsTruth) {
  const ProgramRun run = simulate({"--seed", "12", "--protocol", "full"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("136 rows by protocol full"));
  const Json truthOfSession = Json::parse(contentOf(truth)).at("s1");
  EXPECT_EQ(truthOfSession.at("seed"), 12);
  EXPECT_EQ(truthOfSession.at("kind"), "none");
  EXPECT_EQ(truthOfSession.at("protocol"), "full");
  const Json fit = Json::parse(alidadeCli({"fit", session, "--json"}).out);
  const double sigma = fit["intersection"]["sigma_mm"];
  EXPECT_LT(sigma, 0.03);
  EXPECT_NEAR(fit["intersection"]["value_mm"].get<double>(),
              truthOfSession.at("intersection_mm").get<double>(), 5 * sigma);
}

TEST_F(SimulateTest, RepeatsItselfForASeed) {
  simulate({"--seed", "3", "--effect", "collimation=20"});
  const std::string first = contentOf(session), firstTruth = contentOf(truth);
  simulate({"--seed", "3", "--effect", "collimation=20"});
  EXPECT_EQ(contentOf(session), first);
  EXPECT_EQ(contentOf(truth), firstTruth);
  simulate({"--seed", "4", "--effect", "collimation=20"});
  EXPECT_NE(contentOf(session), first);
}

TEST_F(SimulateTest, PutsInWhatIsAsked) {
  const ProgramRun run = simulate({"--effect",          "plane_tilt=0.3,0.1",
                                   "--effect",          "gross_error=180,1,3,1,60,0",
                                   "--intersection",    "-1.5",
                                   "--radius",          "399.5",
                                   "--points",          "9",
                                   "--rounds",          "2",
                                   "--sigma",           "1",
                                   "--sigma-distance",  "0.5",
                                   "--typing-step",     "1",
                                   "--tolerance",       "2.5",
                                   "--title",           "Hall 3",
                                   "--notes",           "Cold.",
                                   "--vertical-circle", "elevation"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  const Json known = Json::parse(contentOf(truth)).at("s1");
  EXPECT_EQ(known.at("effects"), Json({{"plane_tilt.x", 0.3}, {"plane_tilt.y", 0.1}}));
  EXPECT_EQ(known.at("intersection_mm"), -1.5);
  EXPECT_EQ(known.at("radius_mm"), 399.5);
  EXPECT_EQ(known.at("causes"), Json({"plane_tilt", "gross_error"}));
  const Json written = Json::parse(contentOf(session));
  EXPECT_EQ(written["positions"][0]["readings"].size(), 18u);
  EXPECT_EQ(written["instrument"]["sigma_horizontal_arcsec"], 1);
  EXPECT_EQ(written["geometry"]["sigma_distance_mm"], 0.5);
  EXPECT_EQ(written["acceptance"]["tolerance_mm"], 2.5);
  EXPECT_EQ(written["title"], "Hall 3");
  EXPECT_EQ(written["notes"], "Cold.");
  EXPECT_EQ(written["geometry"]["vertical_circle"], "elevation");
  EXPECT_THAT(written["positions"][0]["readings"][0]["horizontal"].get<std::string>(),
              ::testing::Not(HasSubstr(".")));
}

// Stated tilts are known from the compensator, in fit and diagnosis; corrected tilts are not in the truth.
TEST_F(SimulateTest, StatesWhatTheCompensatorTells) {
  const std::vector<std::string> ofATilt = {"--effect", "vertical_axis_tilt=20,-70", "--compensator"};
  const auto with = [&](const char* use) {
    std::vector<std::string> more = ofATilt;
    more.emplace_back(use);
    const ProgramRun run = simulate(more);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return Json::parse(contentOf(session))["positions"][0]["readings"][0];
  };
  EXPECT_FALSE(with("off").contains("tilt_cross_arcsec"));
  EXPECT_EQ(with("on")["corrections"], "inclination standing_axis");
  EXPECT_EQ(Json::parse(contentOf(truth)).at("s1").at("kind"), "none");
  // 70″ with a direction error of up to 9°, and 1″ of the compensator.
  EXPECT_NEAR(with("measured")["tilt_cross_arcsec"].get<double>(), 70, 10);
  const Json diagnosis = Json::parse(alidadeCli({"diagnose", session, "--json"}).out);
  EXPECT_EQ(diagnosis["known"].size(), 2U);
  EXPECT_THAT(diagnosis["known"][1]["known"]["from"].get<std::string>(), HasSubstr("compensator"));
  EXPECT_EQ(simulate({"--compensator", "perhaps"}).exitCode, 2);
}

TEST_F(SimulateTest, RefusesWhatCannotBeDone) {
  const auto refusal = [&](std::vector<std::string> more) {
    const ProgramRun run = simulate(std::move(more));
    expectRefusal(run);
    EXPECT_FALSE(std::filesystem::exists(session));
    return run.err;
  };
  EXPECT_THAT(refusal({"--effect", "moonlight=1"}), HasSubstr("moonlight"));
  EXPECT_THAT(refusal({"--effect", "plane_tilt=1"}), HasSubstr("2 sizes"));
  EXPECT_THAT(refusal({"--protocol", "by-ear"}), HasSubstr("by-ear"));
  EXPECT_THAT(refusal({"--effect", "gross_error=0,1,1,2,60,0"}), HasSubstr("face 2"));
  EXPECT_THAT(refusal({"--distance", "20"}), HasSubstr("cannot be taken"));
  EXPECT_THAT(refusal({"--points", "0"}), HasSubstr("--points"));
  EXPECT_THAT(refusal({"--out", truth}), HasSubstr("--out"));
  expectRefusal(alidadeCli({"simulate", "--out", session}));
  expectRefusal(alidadeCli({"simulate", "--out", "/no/such/folder/s.alidade", "--truth", truth}));
  expectRefusal(alidadeCli({"simulate", "--out", truth, "--truth", truth}));
}

// The second output must not overwrite the first.
TEST_F(SimulateTest, RefusesOneFileForSessionAndTruthHoweverItIsNamed) {
  const auto refusal = [&](const std::string& out, const std::string& truthFile) {
    const ProgramRun run = alidadeCli({"simulate", "--out", out, "--truth", truthFile});
    expectRefusal(run);
    return run.err;
  };
  const std::string roundabout = (folder.path() / "." / "s1.alidade").string();
  EXPECT_THAT(refusal(session, roundabout), HasSubstr("--out and --truth name the same file"));
  EXPECT_FALSE(std::filesystem::exists(session));
  std::filesystem::create_symlink(session, truth);
  EXPECT_THAT(refusal(truth, session), HasSubstr("the same file"));
  EXPECT_THAT(refusal(session, "-"), HasSubstr("--truth - names no file"));
  EXPECT_FALSE(std::filesystem::exists(session));
}

TEST_F(SimulateTest, LeavesWhatStoodThereWhereOneOfTheTwoCannotBeWritten) {
  std::ofstream(session) << "kept";
  const ProgramRun run =
      alidadeCli({"simulate", "--out", session, "--truth", (folder.path() / "no" / "t.json").string()});
  expectRefusal(run);
  EXPECT_EQ(contentOf(session), "kept");
  const std::string fresh = (folder.path() / "fresh.alidade").string();
  expectRefusal(alidadeCli({"simulate", "--out", fresh, "--truth", "/no/such/folder/t.json"}));
  EXPECT_FALSE(std::filesystem::exists(fresh));
}

TEST_F(SimulateTest, LeavesWhatStoodThereWhereTheDiskIsFull) {
  std::ofstream(session) << "kept";
  std::ofstream(truth) << "kept, too";
  // Limits files of this call to 8 blocks of 512 bytes; a session takes five times that.
  const ProgramRun run =
      runProgram({.program = "/bin/sh",
                  .arguments = {"-c", "ulimit -f 8; exec \"$0\" \"$@\"", ALIDADE_CLI, "simulate",
                                "--protocol", "full", "--out", session, "--truth", truth}});
  expectRefusal(run);
  EXPECT_THAT(run.err, HasSubstr(session + " cannot be written: "));
  const ProgramRun full = alidadeCli({"simulate", "--out", session, "--truth", "/dev/full"});
  expectRefusal(full);
  EXPECT_THAT(full.err, HasSubstr("/dev/full cannot be written: the disk is full"));
  EXPECT_EQ(contentOf(session), "kept");
  EXPECT_EQ(contentOf(truth), "kept, too");
}

TEST_F(SimulateTest, WritesToStandardOutputByItsName) {
  const ProgramRun run = alidadeCli({"simulate", "--out", "/dev/stdout", "--truth", "/dev/null"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, ::testing::StartsWith("{\n  \"format\": \"alidade-session\""));
  EXPECT_THAT(run.out, HasSubstr("}\n/dev/stdout: "));
}

TEST_F(SimulateTest, RefusesNumbersThatAreNone) {
  for (const char* option : {"--tolerance", "--intersection", "--radius", "--centre-x", "--typing-step",
                             "--sigma", "--sigma-zero", "--distance"})
    for (const char* value : {"nan", "-nan", "inf", "1e999", "2mm", ""}) {
      const ProgramRun run = simulate({option, value});
      expectRefusal(run);
      EXPECT_THAT(run.err, HasSubstr(option)) << value;
    }
  EXPECT_EQ(simulate({"--intersection", "+0.5"}).exitCode, 0);
}

TEST_F(SimulateTest, WritesOverNoInstrumentRecord) {
  const std::string text = R"({"format": "alidade-instrument", "version": 1, "serial": "4711",
      "date": "2026-03-01", "known": [{"effect": "trunnion_tilt", "value": 1, "sigma": 1, "unit": "arcsec",
      "from": "check"}]})";
  const std::string record = folder.file("t.alidade-instrument", text);
  for (const char* option : {"--out", "--truth"}) {
    std::vector<std::string> call{"simulate", "--out", session, "--truth", truth, "--instrument", record};
    *(std::find(call.begin(), call.end(), option) + 1) = record;
    const ProgramRun run = alidadeCli(call);
    expectRefusal(run);
    EXPECT_THAT(run.err, HasSubstr("this is the file being read"));
    EXPECT_EQ(contentOf(record), text);
  }
}

TEST_F(SimulateTest, ListsEffectsAndProtocols) {
  const ProgramRun run = alidadeCli({"simulate", "--help"});
  EXPECT_EQ(run.exitCode, 0);
  for (const char* name : {"--effect", "two-face", "trunnion_tilt", "plane_tilt.x=0.3", "orientation_jump"})
    EXPECT_THAT(run.out, HasSubstr(name));
}

}  // namespace
}  // namespace alidade::test
