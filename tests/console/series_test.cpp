#include <gmock/gmock.h>

#include <filesystem>

#include "tests/console/console.h"

// `diagnose` of several files, or of a folder: a series.

namespace alidade::test {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

const std::string storedSeries = ALIDADE_REFERENCE_DIR "/series";

TEST(Series, SaysWhatAFolderShares) {
  const ProgramRun run = alidadeCli({"diagnose", storedSeries + "/series-06"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("trunnion tilt of instrument T-1"));
  EXPECT_THAT(run.out, HasSubstr("Within the series"));
  EXPECT_EQ(run.err, "");
}

TEST(Series, GivesOneDocument) {
  const ProgramRun run = alidadeCli({"diagnose", storedSeries + "/series-06", "--json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Json answer = Json::parse(run.out);
  const ProgramRun alone = alidadeCli({"diagnose", storedSeries + "/series-06/01.alidade", "--json"});
  const Json one = Json::parse(alone.out);
  for (const auto& [key, value] : one.items())
    if (key != "shape" && key != "program" && key != "session_sha256") {
      EXPECT_TRUE(answer["series"].contains(key)) << key;
      EXPECT_TRUE(answer["sessions"][0].contains(key)) << key;
    }
  EXPECT_EQ(answer["program"], one["program"]);
  ASSERT_EQ(answer["sessions"].size(), 12u);
  EXPECT_EQ(answer["sessions"][0]["session"], one["session"]);
  ASSERT_FALSE(answer["series"]["causes"].empty());
  const Json& cause = answer["series"]["causes"][0];
  EXPECT_EQ(cause["effect"], "trunnion_tilt");
  EXPECT_EQ(cause["owner"], "instrument");
  EXPECT_EQ(cause["sessions"].size(), 12u);
  EXPECT_EQ(cause["sessions"][0], one["session"]);
}

TEST(Series, DoesNotDependOnTheNumberOfThreads) {
  const ProgramRun one = alidadeCli({"diagnose", storedSeries + "/series-07", "--json", "--threads", "1"});
  const ProgramRun four = alidadeCli({"diagnose", storedSeries + "/series-07", "--json", "--threads", "4"});
  EXPECT_EQ(one.exitCode, 0) << one.err;
  EXPECT_EQ(one.out, four.out);
}

TEST(Series, ABadFileDoesNotStopTheRest) {
  const TemporaryFolder folder;
  const std::string bad = folder.file("bad.alidade", "{");
  const ProgramRun run = alidadeCli(
      {"diagnose", storedSeries + "/series-06/01.alidade", bad, storedSeries + "/series-06/02.alidade"});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_THAT(run.err, HasSubstr("bad.alidade: "));
  EXPECT_EQ(std::ranges::count(run.err, '\n'), 1);
  EXPECT_THAT(run.out, HasSubstr("2 sessions"));
}

TEST(Series, CountsACopyOnce) {
  const TemporaryFolder folder;
  for (const char* name : {"01", "02", "03"})
    std::filesystem::copy_file(storedSeries + "/series-06/" + name + ".alidade",
                               folder.path() / (std::string(name) + ".alidade"));
  const std::string before = alidadeCli({"diagnose", folder.path().string(), "--json"}).out;
  std::filesystem::copy_file(folder.path() / "02.alidade", folder.path() / "04.alidade");
  const ProgramRun run = alidadeCli({"diagnose", folder.path().string(), "--json"});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_EQ(run.err, (folder.path() / "04.alidade").string() +
                         ": holds the same readings as 02.alidade: counted once\n");
  Json once = Json::parse(before), twice = Json::parse(run.out);
  EXPECT_EQ(twice["sessions"], once["sessions"]);
  EXPECT_EQ(twice["series"]["findings"][0]["text"],
            "04.alidade holds the same readings as 02.alidade: counted once.");
  EXPECT_EQ(twice["series"]["findings"][0]["severity"], "note");
  twice["series"]["findings"].erase(0);
  EXPECT_EQ(twice["series"], once["series"]);
  const ProgramRun each = alidadeCli({"diagnose", "--each", folder.path().string(), "--json"});
  EXPECT_EQ(std::ranges::count(each.out, '\n'), 4) << "each by itself is answered";
}

TEST(Series, RefusesWhatIsNone) {
  const TemporaryFolder folder;
  expectRefusal(alidadeCli({"diagnose", folder.path().string()}));
  expectRefusal(alidadeCli({"diagnose", storedSeries + "/series-06", "--with-reference"}));
}

TEST(Series, IsScored) {
  const ProgramRun run = alidadeCli({"trial", "--score", storedSeries, "--json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Json answer = Json::parse(run.out);
  EXPECT_EQ(answer["named"]["hits"], answer["named"]["count"]);
  EXPECT_EQ(answer["owner_right"]["hits"], answer["owner_right"]["count"]);
  EXPECT_EQ(answer["silent_where_empty"]["hits"], answer["silent_where_empty"]["count"]);
  EXPECT_EQ(alidadeCli({"trial", "--series", "2", "--seed", "4"}).exitCode, 0);
}

}  // namespace
}  // namespace alidade::test
