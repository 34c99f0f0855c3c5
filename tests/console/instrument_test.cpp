#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/console/console.h"
#include "tests/support/file_content.h"

// `alidade-cli instrument`: the field check of a theodolite.

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

const std::string sample = ALIDADE_SAMPLES_DIR "/instrument-check.gsi";

ProgramRun instrumentOf(const std::string& input, std::vector<std::string> options = {}) {
  options.insert(options.begin(), {"instrument", "-"});
  return runProgram({.program = ALIDADE_CLI, .arguments = options, .input = input});
}

TEST(InstrumentCommand, FindsWhatTheSampleWasMadeOf) {
  const ProgramRun run = alidadeCli({"instrument", sample, "--sigma", "1", "--json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Json json = Json::parse(run.out);
  ASSERT_EQ(json["stations"].size(), 2U);
  EXPECT_EQ(json["stations"][0]["station"], "P1");
  EXPECT_EQ(json["stations"][0]["dof_direction"], 12);
  EXPECT_EQ(json["stations"][0]["dof_zenith"], 15);
  const Json& pooled = json["pooled"];
  EXPECT_EQ(pooled["dof_direction"], 24);
  EXPECT_EQ(pooled["dof_zenith"], 30);
  // 1.1″ of a reading is 0.78″ of a mean of two. With 24 degrees of freedom s scatters by 14 %; the tolerance
  // is three times that.
  EXPECT_NEAR(pooled["s_direction_arcsec"], 0.78, 0.34);
  EXPECT_NEAR(pooled["s_zenith_arcsec"], 0.78, 0.30);
  const double index = pooled["index_arcsec"], u = pooled["u_index_arcsec"];
  EXPECT_NEAR(index, -5, 3 * u);
  for (const Json& station : json["stations"]) {
    const Json& sight = station["line_of_sight"];
    const double e = sight["eccentricity_mm"], uOfE = sight["u_eccentricity_mm"];
    EXPECT_NEAR(e, 0.12, 0.05) << "±" << uOfE;
  }
  EXPECT_TRUE(json["tests"]["direction"]["within"]);
}

TEST(InstrumentCommand, TellsPeople) {
  const ProgramRun run = alidadeCli({"instrument", sample});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  for (const char* text : {"SIMULATED, 123456", "ISO 17123-3", "pooled", "P1, by round", "P1, by target",
                           "is proportional to 1/D"})
    EXPECT_THAT(run.out, HasSubstr(text));
}

TEST(InstrumentCommand, TellsItsVerdictFirst) {
  for (const auto& [sigma, verdict] : {std::pair("1", "Passed: "), std::pair("0.3", "Failed: ")}) {
    const ProgramRun run = alidadeCli({"instrument", sample, "--sigma", sigma});
    EXPECT_EQ(run.out.find(verdict), run.out.find("\n\n") + 2) << run.out;
    EXPECT_THAT(run.out, HasSubstr("(limit "));
  }
  EXPECT_THAT(alidadeCli({"instrument", sample}).out, HasSubstr("\nNot judged: "));
  const auto verdict = [](std::vector<std::string> options) {
    options.insert(options.begin(), {"instrument", sample, "--json"});
    return Json::parse(alidadeCli(options).out)["verdict"];
  };
  EXPECT_EQ(verdict({}), "not_judged");
  EXPECT_EQ(verdict({"--sigma", "1"}), "passed");
  EXPECT_EQ(verdict({"--sigma", "1", "--sigma-vertical", "0.3"}), "failed");
}

TEST(InstrumentCommand, StatesInstrumentAndDays) {
  const TemporaryFolder folder;
  const std::string record = folder.path() / "r.alidade-instrument";
  const ProgramRun run = alidadeCli({"instrument", sample, "--json", "--record", record, "--name", "TM",
                                     "--date", "2026-03-01", "--due", "2027-03-01"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Json json = Json::parse(run.out), written = Json::parse(contentOf(record));
  EXPECT_EQ(json["instrument"], Json({{"name", "TM"}, {"serial", "123456"}}));
  EXPECT_EQ(json["measured_on"], "2026-03-01");
  EXPECT_EQ(json["next_check_due"], "2027-03-01");
  EXPECT_EQ(written["next_check_due"], "2027-03-01");
  EXPECT_EQ(written["name"], "TM");
  for (const auto& [option, day] :
       {std::pair("--date", "1 March"), std::pair("--due", "soon"), std::pair("--due", "1999-01-01")})
    expectRefusal(alidadeCli({"instrument", sample, option, day}));
}

TEST(InstrumentCommand, TakesSeveralFilesAndStandardInput) {
  const std::string table =
      "target,hz,v\nA,10.0000,80.0910\nB,50.0000,85.7000\nB,230.0010,274.3000\nA,190.0020,279.9100\n";
  const ProgramRun run = instrumentOf(table, {sample, "--json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["stations"].size(), 3U);
  EXPECT_EQ(json["stations"][0]["rounds"], 1);
  EXPECT_TRUE(json["stations"][0]["s_direction_arcsec"].is_null());
  EXPECT_THAT(run.err, HasSubstr("numbers without a unit are read as"));
}

TEST(InstrumentCommand, RefusesInOneLine) {
  expectRefusal(alidadeCli({"instrument"}));
  expectRefusal(alidadeCli({"instrument", "/nowhere.gsi"}));
  expectRefusal(instrumentOf("target,hz,v\nA,10°,88°71'\n"));
  expectRefusal(instrumentOf(""));
  expectRefusal(alidadeCli({"instrument", sample, "--sigma", "-1"}));
  expectRefusal(alidadeCli({"instrument", paperSession}));
  EXPECT_THAT(instrumentOf("target,hz,v\nA,10°,88°71'\n").err, HasSubstr("standard input: line 2, column 7"));
}

}  // namespace
}  // namespace alidade::test
