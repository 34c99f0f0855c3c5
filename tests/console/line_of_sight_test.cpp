#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/console/console.h"
#include "tests/support/file_content.h"

// The record of an instrument check at 2.4 m and 60 m, simulated with c = 8″ and a line of sight 0.117 mm
// from the axis. In the session at L 2.405 m, targets are 2.438 m away, where both together are 17.90″.

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

class LineOfSightTest : public testing::Test {
 protected:
  void SetUp() override {
    const ProgramRun check =
        alidadeCli({"instrument", ALIDADE_REFERENCE_DIR "/import/check-two-distances.csv", "--record", record,
                    "--date", "2026-03-14"});
    ASSERT_EQ(check.exitCode, 0) << check.err;
    const ProgramRun made = alidadeCli(
        {"simulate", "--out", session, "--truth", truth, "--seed", "3", "--protocol", "two-face", "--effect",
         "collimation=17.897", "--effect", "vertical_index=-3", "--sigma", "0.5", "--distance", "2405"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
  }

  /// The diagnosis with the record after `change`.
  template <typename Change>
  Json diagnosed(const Change& change) const {
    Json changed = Json::parse(contentOf(record));
    // Seven degrees of freedom determine σ to 27 %; here it is 0.2″ by chance. Both were simulated with 0.5″.
    changed["sigma_horizontal_arcsec"] = changed["sigma_vertical_arcsec"] = 0.5;
    change(changed);
    const ProgramRun run = alidadeCli({"diagnose", session, "--json", "--instrument",
                                       folder.file("changed.alidade-instrument", changed.dump())});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return Json::parse(run.out);
  }

  TemporaryFolder folder;
  const std::string record = (folder.path() / "t.alidade-instrument").string(),
                    session = (folder.path() / "s.alidade").string(),
                    truth = (folder.path() / "truth.json").string();
};

TEST_F(LineOfSightTest, IsInTheRecordOfTheCheck) {
  const Json written = Json::parse(contentOf(record));
  EXPECT_NEAR(written.at("line_of_sight_mm"), 0.117, 3 * 0.0025);
  EXPECT_NEAR(written.at("sigma_line_of_sight_mm"), 0.0025, 5e-5);
  EXPECT_NEAR(written.at("line_of_sight_correlation"), -0.7348, 1e-4);
  EXPECT_EQ(written.at("date"), "2026-03-14");
  EXPECT_EQ(written.at("known").at(0).at("effect"), "collimation");
  EXPECT_NEAR(written.at("known").at(0).at("value"), 8, 3 * 0.15);
}

TEST_F(LineOfSightTest, AccountsForTheGapAtTheDistanceOfTheSession) {
  const Json answer = diagnosed([](Json&) {});
  EXPECT_EQ(answer.at("verdict"), "within-noise");
  EXPECT_THAT(answer.at("sentence").get<std::string>(), HasSubstr("The known sizes (collimation"));
  const Json& known = answer.at("known").at(0);
  EXPECT_EQ(known.at("effect"), "collimation");
  // u of c + e/D, with their correlation, is 0.17″; the tolerance is three times that.
  EXPECT_NEAR(known.at("known").at("value"), 17.9, 0.5);
  EXPECT_LT(known.at("known").at("sigma"), 0.2);
}

TEST_F(LineOfSightTest, ThatARecordLeavesOutBlamesNoOtherCause) {
  const Json answer = diagnosed([](Json& changed) {
    for (const char* member : {"line_of_sight_mm", "sigma_line_of_sight_mm", "line_of_sight_correlation"})
      changed.erase(member);
  });
  EXPECT_EQ(answer.at("verdict"), "within-noise");
  EXPECT_NEAR(answer.at("known").at(0).at("known").at("sigma"), 8.46, 0.01) << "0.1 mm at 2.438 m";
}

TEST_F(LineOfSightTest, OfAWrongRecordIsNotBelieved) {
  for (const double wrong : {-0.117, 0.5}) {
    const Json answer = diagnosed([wrong](Json& changed) { changed["line_of_sight_mm"] = wrong; });
    EXPECT_EQ(answer.at("verdict"), "ambiguous") << wrong;
    EXPECT_THAT(answer.at("sentence").get<std::string>(), HasSubstr("out of date")) << wrong;
  }
}

}  // namespace
}  // namespace alidade::test
