#include <gmock/gmock.h>

#include <filesystem>
#include <set>

#include "tests/console/console.h"
#include "tests/support/file_content.h"

// The statements of samples/README.md on each sample, and that its recipe still produces it.

namespace alidade::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

const fs::path samples = ALIDADE_SAMPLES_DIR;

struct Story {
  const char* name;
  const char* verdict;
  std::vector<std::string> causes;      ///< according to their truth, in any order
  std::vector<std::string> lookAlikes;  ///< named as causes or look-alikes
};

class SampleTest : public ::testing::TestWithParam<Story> {};

TEST_P(SampleTest, IsDiagnosedAsItsLineSays) {
  const Story& story = GetParam();
  const std::string file = (samples / (std::string(story.name) + ".alidade")).string();
  const ProgramRun run = alidadeCli({"diagnose", file, "--json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Json diagnosis = Json::parse(run.out);
  EXPECT_EQ(diagnosis["verdict"], story.verdict);
  std::set<std::string> named;
  for (const Json& cause : diagnosis["causes"]) named.insert(cause["effect"]);
  if (!story.lookAlikes.empty()) {
    // Which of the indistinguishable causes is named depends on chance.
    for (const Json& cause : diagnosis["causes"])
      named.insert(cause["indistinguishable_from"].begin(), cause["indistinguishable_from"].end());
    EXPECT_THAT(named, IsSupersetOf(story.lookAlikes));
  } else {
    EXPECT_EQ(named, std::set<std::string>(story.causes.begin(), story.causes.end()));
  }
  EXPECT_THAT(contentOf(samples / "README.md"), HasSubstr(std::string("| `") + story.name + ".alidade`"));
}

INSTANTIATE_TEST_SUITE_P(
    EachKindOfVerdict, SampleTest,
    ::testing::Values(
        Story{"paper-table-1",
              "several-causes",
              {},
              {"plane_offset", "radius_change", "axial_shift", "orientation_jump", "underestimated_noise"}},
        Story{"clean-session", "within-noise", {}, {}}, Story{"two-faces", "within-noise", {}, {}},
        Story{"misreading", "single-cause", {"gross_error"}, {}},
        Story{"trunnion-tilt", "single-cause", {"trunnion_tilt"}, {}},
        Story{"look-alikes", "ambiguous", {}, {"trunnion_tilt", "plane_warp"}},
        Story{"two-causes", "several-causes", {"trunnion_tilt", "vertical_drift"}, {}},
        Story{"unknown-form", "not-in-catalogue", {}, {}},
        Story{"dented-guideway", "not-in-catalogue", {}, {}},
        Story{"settling-tripod", "not-in-catalogue", {}, {}},
        Story{"own-effect", "single-cause", {"own:rail_joint"}, {}},
        Story{"knocked-tripod", "single-cause", {"orientation_jump"}, {}},
        Story{"noisy-readings", "single-cause", {"underestimated_noise"}, {}},
        Story{"known-instrument", "within-noise", {}, {}},
        Story{"stale-record", "single-cause", {"trunnion_tilt"}, {}}),
    [](const auto& story) {
      std::string name = story.param.name;
      std::erase(name, '-');
      return name;
    });

Json diagnosisOf(const char* name) {
  const std::string file = (samples / (std::string(name) + ".alidade")).string();
  return Json::parse(alidadeCli({"diagnose", file, "--json"}).out);
}

// 0.40 mm is the truth in make.sh; 60″ and −40″ are the steps, after 25 of 36 readings.
TEST(Samples, SizesAreThoseOfTheRecipe) {
  for (const char* name : {"two-causes", "knocked-tripod"}) {
    const Json after = diagnosisOf(name)["intersection"]["after"];
    EXPECT_NEAR(after["value_mm"].get<double>(), 0.4, after["expanded_mm"].get<double>()) << name;
  }
  const Json parameters = diagnosisOf("knocked-tripod")["causes"][0]["parameters"];
  for (const auto& [index, truth] : {std::pair{0, 60.0}, std::pair{1, -40.0}, std::pair{2, 26.0}})
    EXPECT_NEAR(parameters[index]["value"].get<double>(), truth,
                3 * parameters[index]["sigma"].get<double>() + 1e-9);
}

// 0.12 mm at 105° is the truth in make.sh. Without the effect its form is found.
TEST(Samples, AnOwnEffectIsFoundWithItsSizeOrAsAForm) {
  const Json size = diagnosisOf("own-effect")["causes"][0]["parameters"][0];
  EXPECT_NEAR(size["value"].get<double>(), 0.12, 3 * size["sigma"].get<double>());
  const std::string file = (samples / "own-effect.alidade").string();
  const Json forms =
      Json::parse(alidadeCli({"diagnose", file, "--without", "own:rail_joint", "--json"}).out)["forms"];
  ASSERT_EQ(forms.size(), 1u);
  EXPECT_EQ(forms[0]["carrier"], "radial");
  EXPECT_EQ(forms[0]["form"], "step");
  const Json& numbers = forms[0]["parameters"];
  EXPECT_NEAR(numbers["at_deg"].get<double>(), 105, 3 * numbers["standard_uncertainty_at_deg"].get<double>());
}

// The truth is in make.sh, and that of the settling tripod in samples/README.md.
TEST(Samples, FormsAreThoseOfTheTruth) {
  struct Expected {
    const char *sample, *carrier, *form, *of, *number;
    double truth;
  };
  for (const Expected& expected :
       {Expected{"unknown-form", "radial", "harmonic", "s", "order", 5},
        Expected{"dented-guideway", "radial", "bump", "s", "at_deg", 40},
        Expected{"settling-tripod", "orientation", "exponential", "t", "tau", 0.1762}}) {
    const Json forms = diagnosisOf(expected.sample)["forms"];
    ASSERT_EQ(forms.size(), 1u) << expected.sample;
    EXPECT_EQ(forms[0]["carrier"], expected.carrier);
    EXPECT_EQ(forms[0]["form"], expected.form);
    EXPECT_EQ(forms[0]["of"], expected.of);
    const Json& numbers = forms[0]["parameters"];
    EXPECT_NEAR(numbers[expected.number].get<double>(), expected.truth,
                3 * numbers[std::string("standard_uncertainty_") + expected.number].get<double>() + 1e-9)
        << expected.sample;
    EXPECT_EQ(forms[0]["clean_range"].empty(), expected.form == std::string("harmonic")) << expected.sample;
  }
  // The dent is 8° wide and 0.3 mm deep; σ is 0.024 mm. At 2.25 widths, 22° and 58°, it falls below σ.
  const Json clean = diagnosisOf("dented-guideway")["forms"][0]["clean_range"];
  ASSERT_EQ(clean.size(), 2u);
  EXPECT_NEAR(clean[0][1].get<double>(), 22, 3);
  EXPECT_NEAR(clean[1][0].get<double>(), 58, 3);
}

TEST(Samples, RecipeMakesThemByteByByte) {
  const TemporaryFolder folder;
  const ProgramRun run = runProgram(
      {.program = "/usr/bin/env",
       .arguments = {"bash", (samples / "make.sh").string(), ALIDADE_CLI, folder.path().string()}});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  std::size_t made = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
    if (entry.is_directory()) continue;
    EXPECT_EQ(contentOf(entry.path()), contentOf(samples / fs::relative(entry.path(), folder.path())))
        << entry.path();
    ++made;
  }
  EXPECT_EQ(made, 30u);
}

// Effects visible in eight sessions of one theodolite together, and in hardly any of them alone.
TEST(Samples, SeriesNamesWhatItsSessionsShare) {
  const ProgramRun run = alidadeCli({"diagnose", (samples / "series").string(), "--json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Json answer = Json::parse(run.out);
  ASSERT_EQ(answer["series"]["causes"].size(), 1u);
  const Json& cause = answer["series"]["causes"][0];
  EXPECT_EQ(cause["effect"], "trunnion_tilt");
  EXPECT_EQ(cause["serial"], "T-7");
  EXPECT_NEAR(cause["parameters"][0]["value"].get<double>(), 14,
              3 * cause["parameters"][0]["sigma"].get<double>());
  std::size_t alone = 0;
  for (const Json& session : answer["sessions"]) {
    alone += session["alone"]["verdict"] == "within-noise" ? 0 : 1;
    EXPECT_EQ(session["verdict"], "within-noise") << session["session"];
  }
  EXPECT_LE(alone, 3u);
}

}  // namespace
}  // namespace alidade::test
