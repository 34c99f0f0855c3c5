#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/console/console.h"
#include "tests/support/file_content.h"

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

const std::string tilted = ALIDADE_SAMPLES_DIR "/trunnion-tilt.alidade";  // by 25″

Json recordOf(double tilt) {
  return {{"format", "alidade-instrument"},
          {"version", 1},
          {"serial", "4711"},
          {"date", "2026-03-01"},
          {"known",
           {{{"effect", "trunnion_tilt"},
             {"value", tilt},
             {"sigma", 1},
             {"unit", "arcsec"},
             {"from", "check"}}}}};
}

Json diagnosedWith(const Json& record) {
  const TemporaryFolder folder;
  const ProgramRun run = alidadeCli(
      {"diagnose", tilted, "--json", "--instrument", folder.file("t.alidade-instrument", record.dump())});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  return Json::parse(run.out);
}

TEST(InstrumentOption, TakesTheRecordForThisRun) {
  const Json answer = diagnosedWith(recordOf(25));
  EXPECT_EQ(answer.at("verdict"), "within-noise");
  const Json& known = answer.at("known").at(0);
  EXPECT_EQ(known.at("effect"), "trunnion_tilt");
  EXPECT_EQ(known.at("known").at("value").get<double>(), 25);  // as typed
  EXPECT_EQ(known.at("known").at("from"), "instrument record t.alidade-instrument of 2026-03-01: check");
  EXPECT_EQ(known.at("known").at("date"), "2026-03-01");
  EXPECT_NEAR(known.at("readings").at("value").get<double>(), 25,
              3 * known.at("readings").at("sigma").get<double>());
  EXPECT_LT(known.at("stale_probability").get<double>(), 0.02);
  EXPECT_THAT(answer.at("sentence").get<std::string>(), HasSubstr("The known sizes (trunnion tilt)"));
}

TEST(InstrumentOption, FindsAStaleRecordOut) {
  const Json answer = diagnosedWith(recordOf(0));
  EXPECT_EQ(answer.at("verdict"), "single-cause");
  EXPECT_EQ(answer.at("causes").at(0).at("effect"), "trunnion_tilt");
  EXPECT_EQ(answer.at("causes").at(0).at("stale"), true);
  EXPECT_GT(answer.at("known").at(0).at("stale_probability").get<double>(), 0.9);
  EXPECT_THAT(answer.at("sentence").get<std::string>(), HasSubstr("the known size is out of date"));
}

TEST(InstrumentOption, IsSaidInTextToo) {
  const TemporaryFolder folder;
  const std::string record = folder.file("t.alidade-instrument", recordOf(0).dump());
  const ProgramRun diagnosis = alidadeCli({"diagnose", tilted, "--instrument", record});
  EXPECT_THAT(diagnosis.out, HasSubstr("Known sizes of instrument and device"));
  EXPECT_THAT(diagnosis.out, HasSubstr("the known size is out of date"));
  const ProgramRun fit = alidadeCli({"fit", tilted, "--instrument", record});
  EXPECT_EQ(fit.exitCode, 0) << fit.err;
  EXPECT_THAT(fit.out, HasSubstr("best explained by trunnion tilt different from its known value (9"));
}

TEST(InstrumentOption, SaysThatTheNextCheckIsOverdue) {
  const TemporaryFolder folder;
  const auto errorsIfDueOn = [&](const std::string& due) {
    const std::string record = folder.file(
        "r.alidade-instrument", R"({"format": "alidade-instrument", "version": 1, "date": "2024-01-01", )"
                                R"("next_check_due": ")" +
                                    due + R"(", "known": []})");
    return alidadeCli({"fit", paperSession, "--no-diagnosis", "--instrument", record}).err;
  };
  EXPECT_THAT(errorsIfDueOn("2025-01-01"), HasSubstr("was due on 2025-01-01"));
  EXPECT_EQ(errorsIfDueOn("2100-01-01").find("due"), std::string::npos);
  EXPECT_THAT(errorsIfDueOn("2023-01-01"), HasSubstr("next_check_due"));
}

TEST(InstrumentOption, IsRefusedInOneSentence) {
  const TemporaryFolder folder;
  Json session = Json::parse(contentOf(tilted));
  session["instrument"]["serial"] = "4712";
  const std::string file = folder.file("s.alidade", session.dump()),
                    record = folder.file("t.alidade-instrument", recordOf(0).dump());
  for (const char* command : {"fit", "diagnose"}) {
    const ProgramRun run = alidadeCli({command, file, "--instrument", record});
    expectRefusal(run);
    EXPECT_THAT(
        run.err,
        HasSubstr("instrument.serial: “4712” is not the serial number in the instrument record (“4711”)"));
  }
  const ProgramRun broken =
      alidadeCli({"fit", file, "--instrument", folder.file("b.alidade-instrument", "{}")});
  expectRefusal(broken);
  EXPECT_THAT(broken.err, HasSubstr("b.alidade-instrument: format: is missing"));
  expectRefusal(alidadeCli({"fit", file, "--instrument", folder.path().string() + "/none"}));
}

}  // namespace
}  // namespace alidade::test
