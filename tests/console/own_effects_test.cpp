#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/console/console.h"

// Effects of the user's own on the command line: simulated, left out, read from files, written to a file.

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr, testing::Not;

constexpr const char* wave = R"json({
  "format": "alidade-effect", "version": 1, "id": "wave", "owner": {"device": "G-7"},
  "formula": "radial = A*cos(7*s) + B*sin(7*s)",
  "parameters": [{"name": "A", "plausible": 0.2, "unit": "mm"}, {"name": "B", "plausible": 0.2, "unit": "mm"}]
})json";

/// A session of device G-7, simulated with the wave, which the session file does not define.
struct WavySession {
  TemporaryFolder folder;
  std::string effect = folder.file("wave.alidade-effect", wave), session = path("s.alidade");

  WavySession() {
    const ProgramRun run =
        alidadeCli({"simulate", "--out", session, "--truth", path("t.json"), "--protocol", "full",
                    "--device-serial", "G-7", "--effects", effect, "--effect", "own:wave=0.15,0.1"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
  }
  std::string path(const char* name) const { return (folder.path() / name).string(); }
};

Json diagnosed(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "diagnose");
  arguments.emplace_back("--json");
  const ProgramRun run = alidadeCli(arguments);
  EXPECT_EQ(run.exitCode, 0) << run.err;
  return Json::parse(run.out);
}

TEST(OwnEffects, AreTakenUpByTheirOwner) {
  const WavySession wavy;
  EXPECT_EQ(diagnosed({wavy.session}).at("verdict"), "not-in-catalogue");
  const Json known = diagnosed({wavy.session, "--effects", wavy.folder.path().string()});
  EXPECT_EQ(known.at("verdict"), "single-cause");
  EXPECT_EQ(known.at("causes").at(0).at("effect"), "own:wave");
  std::string foreign = wave;
  foreign.replace(foreign.find("G-7"), 3, "G-8");
  const std::string other = wavy.folder.file("other.alidade-effect", foreign);
  EXPECT_EQ(diagnosed({wavy.session, "--effects", other}).at("verdict"), "not-in-catalogue");
  std::ifstream truth(wavy.path("t.json"));
  EXPECT_EQ(Json::parse(truth).at("s").at("kind"), "own:wave");
}

TEST(OwnEffects, AreInFitPlanAndText) {
  const WavySession wavy;
  const ProgramRun fit = alidadeCli({"fit", wavy.session, "--effects", wavy.effect});
  EXPECT_EQ(fit.exitCode, 0) << fit.err;
  EXPECT_THAT(fit.out, HasSubstr("best explained by wave ("));
  const ProgramRun plan = alidadeCli({"plan", wavy.session, "--effects", wavy.effect, "--json"});
  EXPECT_EQ(plan.exitCode, 0) << plan.err;
  EXPECT_THAT(plan.out, HasSubstr("\"own:wave\""));
  const ProgramRun text = alidadeCli({"diagnose", wavy.session, "--effects", wavy.effect});
  EXPECT_THAT(text.out, HasSubstr("One cause: wave"));
}

TEST(OwnEffects, AreTheCauseOfASeries) {
  const WavySession one;
  const std::string second = one.path("second.alidade");
  const ProgramRun run = alidadeCli({"simulate", "--out", second, "--truth", one.path("u.json"), "--seed",
                                     "2", "--protocol", "full", "--device-serial", "G-7", "--effects",
                                     one.effect, "--effect", "own:wave=0.15,0.1"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  const Json series = diagnosed({one.session, second, "--effects", one.effect}).at("series");
  EXPECT_EQ(series.at("verdict"), "single-cause");
  ASSERT_EQ(series.at("causes").size(), 1u);
  EXPECT_EQ(series.at("causes").at(0).at("effect"), "own:wave");
  EXPECT_EQ(series.at("causes").at(0).at("sessions").size(), 2u);
}

/// Three sessions of device G-7 with the wave in each.
std::vector<std::string> wavySeries(const WavySession& first) {
  std::vector<std::string> files{first.session};
  for (const char* seed : {"2", "3"}) {
    files.push_back(first.path((std::string(seed) + ".alidade").c_str()));
    const ProgramRun run = alidadeCli({"simulate", "--out", files.back(), "--truth", first.path("u.json"),
                                       "--seed", seed, "--protocol", "full", "--device-serial", "G-7",
                                       "--effects", first.effect, "--effect", "own:wave=0.15,0.1"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
  }
  return files;
}

TEST(OwnEffects, AreOfferedByASeriesAndThenItsCause) {
  const WavySession first;
  std::vector<std::string> call = wavySeries(first);
  const std::string kept = first.path("kept.alidade-effect");
  std::vector<std::string> keeping = call;
  keeping.insert(keeping.end(), {"--keep-form", kept});
  const Json series = diagnosed(keeping).at("series");
  ASSERT_EQ(series.at("offered_effects").size(), 1u);
  const Json& offered = series.at("offered_effects").at(0);
  EXPECT_EQ(offered.at("form"), "harmonic");
  EXPECT_EQ(offered.at("parameters").at("order"), 7);
  EXPECT_EQ(offered.at("sessions").size(), 3u);
  EXPECT_EQ(offered.at("effect").at("owner"), Json({{"device", "G-7"}}));
  EXPECT_THAT(series.at("sentence").get<std::string>(), HasSubstr("can be kept as an effect"));
  keeping.insert(keeping.begin(), "diagnose");
  const ProgramRun text = alidadeCli(keeping);
  EXPECT_THAT(text.out, HasSubstr("--keep-form keeps it as own:radial_harmonic_7_of_s"));

  call.insert(call.end(), {"--effects", kept});
  const Json known = diagnosed(call).at("series");
  EXPECT_EQ(known.at("verdict"), "single-cause");
  EXPECT_EQ(known.at("causes").at(0).at("effect"), "own:radial_harmonic_7_of_s");
  EXPECT_EQ(known.at("causes").at(0).at("owner"), "guideway");
  EXPECT_EQ(known.at("offered_effects"), Json::array());
  call.insert(call.begin(), "diagnose");
  call.insert(call.end(), {"--keep-form", first.path("none.alidade-effect")});
  const ProgramRun none = alidadeCli(call);
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_THAT(none.err, HasSubstr("no three sessions"));
}

TEST(OwnEffects, AreKeptFromAForm) {
  const WavySession wavy;
  const std::string kept = wavy.path("kept.alidade-effect");
  diagnosed({wavy.session, "--keep-form", kept});
  const Json known = diagnosed({wavy.session, "--effects", kept});
  EXPECT_EQ(known.at("verdict"), "single-cause");
  EXPECT_THAT(known.at("causes").at(0).at("effect"), testing::StartsWith("own:"));
  const ProgramRun none = alidadeCli({"diagnose", wavy.session, "--effects", kept, "--keep-form", kept});
  EXPECT_EQ(none.exitCode, 2) << "no form is left";
  EXPECT_THAT(none.err, HasSubstr("no form"));
}

TEST(OwnEffects, ThatAreOfNoUseAreTold) {
  const WavySession wavy;
  const auto runWithChange = [&](const std::string& from, const std::string& to) {
    std::string changed = wave;
    changed.replace(changed.find(from), from.size(), to);
    const std::string file = wavy.folder.file("changed.alidade-effect", changed);
    return alidadeCli({"diagnose", wavy.session, "--effects", file});
  };
  const ProgramRun wrong = runWithChange("sin(7*s)", "sine(7*s)");
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_THAT(wrong.err, HasSubstr("formula: Line 1, column 25: “sine”"));
  EXPECT_THAT(runWithChange("cos(7*s) + B*sin(7*s)", "cos(2*s) + B*sin(2*s)").err,
              HasSubstr("“arc ellipticity”"));
  EXPECT_EQ(alidadeCli({"fit", wavy.session, "--effects", wavy.path("none")}).exitCode, 2);
}

}  // namespace
}  // namespace alidade::test
