#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/console/console.h"

// A session with a repeated axis angle, from simulation to results.

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

class MeasuredAgain : public testing::Test {
 protected:
  std::string simulated(const std::vector<std::string>& effects = {}) {
    const std::string file = (m_folder.path() / "again.alidade").string();
    std::vector<std::string> call{
        "simulate",   "--out", file,     "--truth", (m_folder.path() / "truth.json").string(),
        "--protocol", "again", "--seed", "5",       "--tolerance",
        "2.5"};
    for (const std::string& effect : effects) call.insert(call.end(), {"--effect", effect});
    const ProgramRun run = alidadeCli(call);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return file;
  }

  static Json answerOf(const std::vector<std::string>& call) {
    const ProgramRun run = alidadeCli(call);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return Json::parse(run.out);
  }

 private:
  TemporaryFolder m_folder;
};

TEST_F(MeasuredAgain, HasOneCentreForEachAxis) {
  const Json fit = answerOf({"fit", simulated(), "--json"});
  const Json& arcs = fit.at("arcs");
  ASSERT_EQ(arcs.size(), 3u);
  EXPECT_EQ(arcs[2].at("axis_deg"), 0);
  EXPECT_EQ(arcs[2].at("time"), 2);
  EXPECT_FALSE(arcs[0].contains("time"));
  for (const char* key : {"center_mm", "radius_mm", "sigma_mm"}) EXPECT_EQ(arcs[2].at(key), arcs[0].at(key));
  EXPECT_NE(arcs[2].at("residual_rms_arcsec"), arcs[0].at("residual_rms_arcsec"));
  EXPECT_TRUE(fit.at("intersection").at("value_mm").is_number());
}

TEST_F(MeasuredAgain, TellsTheRowsOfTheSecondTimeFromThoseOfTheFirst) {
  const Json fit = answerOf({"fit", simulated({"gross_error=0,1,5,1,120,0,2"}), "--json"});
  ASSERT_EQ(fit.at("suspects").size(), 1u);
  EXPECT_EQ(fit["suspects"][0].at("time"), 2);
  EXPECT_THAT(fit["suspects"][0].at("where"), HasSubstr("positions[2].readings[4]"));
  int again = 0;
  for (const Json& reading : fit.at("reliability")) again += reading.contains("time") ? 1 : 0;
  EXPECT_EQ(again, 34);
}

TEST_F(MeasuredAgain, ClosesByWhatTheRepeatsAgreeOn) {
  const Json answer = answerOf({"diagnose", simulated({"zero_slip=0,40,-40,2"}), "--json"});
  std::vector<std::string> of;
  for (const Json& closure : answer.at("closures"))
    if (closure.at("closure") == "repeat") {
      EXPECT_EQ(closure.at("axis_deg"), 0);
      EXPECT_EQ(closure.at("time"), 2);
      of.push_back(closure.at("of"));
      if (of.back() != "radius") {
        EXPECT_GT(closure.at("sigmas").get<double>(), 5) << of.back();
        EXPECT_LT(closure.at("after_sigmas").get<double>(), 3) << of.back();
      }
    }
  EXPECT_EQ(of, (std::vector<std::string>{"x", "y", "radius"}));
  EXPECT_EQ(answer.at("causes").at(0).at("effect"), "orientation_jump");
}

TEST_F(MeasuredAgain, SaysInTextWhichPositionIsMeant) {
  const std::string file = simulated({"gross_error=0,1,5,1,120,0,2"});
  const ProgramRun fit = alidadeCli({"fit", file}), diagnosis = alidadeCli({"diagnose", file});
  EXPECT_THAT(fit.out, HasSubstr("    0° again "));
  EXPECT_THAT(fit.out, HasSubstr("share one centre and one radius."));
  EXPECT_THAT(fit.out, HasSubstr("0° again, point 5, horizontal"));
  EXPECT_THAT(diagnosis.out, HasSubstr("Δx(0° again) − Δx(0°)"));
  EXPECT_THAT(diagnosis.out, HasSubstr("0° again, point 5, horizontal"));
}

}  // namespace
}  // namespace alidade::test
