#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/console/console.h"
#include "tests/support/file_content.h"

// `alidade-cli history`: tables of values, folders of sessions, and their errors.

namespace alidade::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

const std::string year = ALIDADE_SAMPLES_DIR "/history";

Json answerTo(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "history");
  arguments.emplace_back("--json");
  const ProgramRun run = alidadeCli(arguments);
  EXPECT_EQ(run.exitCode, 0) << run.err;
  return Json::parse(run.out);
}

TEST(HistoryCall, OfATableHasTheKeysOfItsContract) {
  const TemporaryFolder folder;
  const Json json = answerTo({folder.file("c.csv", "2001,10,1\n2002,12,2\n2003,13,1\n")});
  ASSERT_THAT(json["values"], SizeIs(3));
  EXPECT_EQ(json["values"][1]["date"], "2002");
  EXPECT_EQ(json["values"][1]["value"], 12.0);
  EXPECT_EQ(json["values"][1]["u"], 2.0);
  EXPECT_NEAR(json["values"][1]["expanded_uncertainty"].get<double>(), 1.959964 * 2, 1e-5);
  EXPECT_NEAR(json["mean"]["value"].get<double>(), 26 / 2.25, 1e-12);
  EXPECT_NEAR(json["mean"]["u"].get<double>(), 1 / 1.5, 1e-12);
  EXPECT_EQ(json["dof"], 2);
  EXPECT_EQ(json["stable"], true);
  EXPECT_THAT(json["steps"], IsEmpty());
  EXPECT_TRUE(json["trend_per_year"]["value"].is_number());
}

TEST(HistoryCall, ReadsStandardInput) {
  const ProgramRun run = runProgram({.program = ALIDADE_CLI,
                                     .arguments = {"history", "-", "--json"},
                                     .input = "2001;1,5;0,1\n2002;1,6;0,1\n"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(Json::parse(run.out)["values"], SizeIs(2));
}

// The statements of samples/README.md.
TEST(HistoryCall, OfTheSampleFindsItsStep) {
  const Json json = answerTo({year});
  ASSERT_THAT(json["steps"], SizeIs(1));
  EXPECT_EQ(json["steps"][0]["date"], "2025-08-11");
  EXPECT_NEAR(json["steps"][0]["size"].get<double>(), 0.25, 2 * json["steps"][0]["u"].get<double>());
  EXPECT_EQ(json["stable"], false);
  EXPECT_EQ(json["course"], "steps");
  EXPECT_EQ(json["device"]["serial"], "G-07");
  EXPECT_THAT(json["values"], SizeIs(12));
  for (const char* id :
       {"intersection", "intersection_of_fit", "o1_x", "o1_y", "o2_x", "o2_y", "radius_0", "radius_180"})
    EXPECT_THAT(json["quantities"][id]["values"], SizeIs(12)) << id;
  EXPECT_EQ(json["quantities"]["radius_0"]["stable"], true);
  EXPECT_THAT(json["congruence"], SizeIs(12 * 11 / 2));
  const Json& ends = json["congruence"][10];
  EXPECT_EQ(ends["second"]["date"], "2025-12-15");
  EXPECT_EQ(ends["changed"], true);
  EXPECT_EQ(ends["device"]["numbers"], 4);
}

TEST(HistoryCall, OfSessionsIsThatOfTheirFolder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(year)) files.push_back(entry.path().string());
  Json named = answerTo(files), whole = answerTo({year});
  named.erase("history");
  whole.erase("history");
  EXPECT_EQ(named, whole);
}

TEST(HistoryCall, AnswersForEachDevice) {
  const TemporaryFolder folder;
  const auto session = [&](const std::string& name, const std::string& serial, const std::string& date) {
    folder.file(name, changedPaperSession([&](Json& json) {
                  json["device"]["serial"] = serial;
                  json["measured_on"] = date;
                }));
  };
  session("1.alidade", "A", "2024-01-01");
  session("2.alidade", "B", "2024-02-01");
  session("3.alidade", "A", "2024-03-01");
  const Json json = answerTo({folder.path().string()});
  ASSERT_THAT(json["devices"], SizeIs(2));
  EXPECT_EQ(json["devices"][0]["device"]["serial"], "A");
  EXPECT_THAT(json["devices"][0]["values"], SizeIs(2));
  EXPECT_TRUE(json["devices"][1]["p_value"].is_null());
  EXPECT_TRUE(json["devices"][1]["stable"].is_null());
}

TEST(HistoryCall, NamesSessionsThatTakeNoPartAndAnswersTheOthers) {
  const TemporaryFolder folder;
  const auto dated = [](const char* date) {
    return changedPaperSession([&](Json& json) { json["measured_on"] = date; });
  };
  folder.file("1.alidade", dated("2024-01-01"));
  const std::string undated = folder.file("2.alidade", dated("")), broken = folder.file("3.alidade", "{");
  const ProgramRun run = alidadeCli({"history", folder.path().string(), "--json"});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_THAT(run.err, HasSubstr(undated + ": has no date"));
  EXPECT_THAT(run.err, HasSubstr(broken + ": "));
  const Json json = Json::parse(run.out);
  EXPECT_THAT(json["values"], SizeIs(1));
  EXPECT_THAT(json["remarks"], SizeIs(2));
}

TEST(HistoryCall, CountsACopyOnce) {
  const TemporaryFolder folder;
  for (const auto& entry : std::filesystem::directory_iterator(year))
    std::filesystem::copy_file(entry.path(), folder.path() / entry.path().filename());
  Json copied = Json::parse(contentOf(folder.path() / "2025-09-12.alidade"));
  copied["title"] = "a copy";
  copied["notes"] = "laid out and named anew";
  const std::string copy = folder.file("z.alidade", copied.dump(7));
  const ProgramRun run = alidadeCli({"history", folder.path().string(), "--json"});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_EQ(run.err, copy + ": holds the same readings as 2025-09-12.alidade: counted once\n");
  Json json = Json::parse(run.out);
  const Json remarks = json["remarks"];
  EXPECT_EQ(remarks, Json({"z.alidade holds the same readings as 2025-09-12.alidade: counted once."}));
  Json once = answerTo({year});
  EXPECT_EQ(json["mean"], once["mean"]);
  EXPECT_THAT(json["values"], SizeIs(12));
}

// Reading a pipe blocks until somebody writes to it.
TEST(HistoryCall, NamesWhatIsNoFileInAFolder) {
  const TemporaryFolder folder;
  std::filesystem::copy_file(year + "/2025-09-12.alidade", folder.path() / "1.alidade");
  const std::string pipe = folder.path() / "2.alidade";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const ProgramRun run = alidadeCli({"history", folder.path().string(), "--json"});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_THAT(run.err, StartsWith(pipe + ": is a pipe, a socket or a device"));
  EXPECT_THAT(Json::parse(run.out)["values"], SizeIs(1));
  std::filesystem::remove(folder.path() / "1.alidade");
  const ProgramRun none = alidadeCli({"history", folder.path().string()});
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_THAT(none.err, HasSubstr("none of the sessions can be used"));
}

TEST(HistoryCall, RefusesWhatHoldsNoHistory) {
  const TemporaryFolder folder;
  const auto refusal = [](const std::string& input) {
    const ProgramRun run = alidadeCli({"history", input});
    expectRefusal(run);
    EXPECT_THAT(run.err, StartsWith(input + ": "));
    return run.err;
  };
  EXPECT_THAT(refusal(folder.path().string()), HasSubstr("holds no session"));
  EXPECT_THAT(refusal("/no/such.csv"), HasSubstr("cannot be opened"));
  EXPECT_THAT(refusal(folder.file("a.csv", "2001,1,0\n")), HasSubstr("line 1, column 8"));
  EXPECT_THAT(refusal(folder.file("b.csv", "")), HasSubstr("no value"));
  EXPECT_THAT(refusal(folder.file("c.csv", "{}")), HasSubstr("no table"));
}

TEST(HistoryCall, OfManyTablesHasALineForEach) {
  const TemporaryFolder folder;
  const std::string a = folder.file("a.csv", "2001,1,0.1\n"), bad = folder.file("b.csv", "2001,1,-1\n"),
                    c = folder.file("c.csv", "2001,3,0.1\n");
  const ProgramRun run = alidadeCli({"history", a, bad, c, "--json"});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 3);
  EXPECT_THAT(run.out, HasSubstr("\"file\": \"" + bad + "\", \"error\": "));
  EXPECT_THAT(run.err, StartsWith(bad + ": line 1"));
}

/// Writes the record of a check on a day with a tilt changed by `more` arcseconds.
std::string recordIn(const TemporaryFolder& folder, const std::string& date, const std::string& due,
                     double more = 0) {
  const std::string path = folder.path() / (date + ".alidade-instrument");
  alidadeCli({"instrument", ALIDADE_SAMPLES_DIR "/instrument-check.gsi", "--date", date, "--record", path});
  Json record = Json::parse(contentOf(path));
  record["known"][1]["value"] = record["known"][1]["value"].get<double>() + more;
  if (!due.empty()) record["next_check_due"] = due;
  folder.file(date + ".alidade-instrument", record.dump(1));
  return path;
}

TEST(HistoryCall, OfRecordsTellsConstantsAndDueDates) {
  const TemporaryFolder folder;
  recordIn(folder, "2024-01-10", "2025-01-10");
  recordIn(folder, "2025-02-10", "2100-01-01");
  const std::string third = recordIn(folder, "2026-01-10", "2026-01-11", 40);
  std::filesystem::copy_file(third, folder.path() / "copy.alidade-instrument");
  const std::string broken = folder.file("x.alidade-instrument", "{}");
  const ProgramRun run = alidadeCli({"history", folder.path().string(), "--json"});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_THAT(run.err, HasSubstr(broken + ": "));
  EXPECT_THAT(run.err, HasSubstr("holds the same record"));
  const Json json = Json::parse(run.out);
  ASSERT_THAT(json["instruments"], SizeIs(1));
  const Json& instrument = json["instruments"][0];
  EXPECT_EQ(instrument["instrument"]["serial"], "123456");
  EXPECT_THAT(instrument["records"], SizeIs(3));
  EXPECT_EQ(instrument["records"][0]["next_check_due"], "2025-01-10");
  EXPECT_EQ(instrument["quantities"]["collimation"]["stable"], true);
  EXPECT_EQ(instrument["quantities"]["trunnion_tilt"]["stable"], false);
  EXPECT_THAT(instrument["quantities"]["line_of_sight"]["values"], SizeIs(3));
  EXPECT_THAT(json["remarks"], SizeIs(2));
  const ProgramRun text = alidadeCli({"history", folder.path().string()});
  for (const char* words : {"checked late", "overdue", "trunnion tilt", "offset of the line of sight"})
    EXPECT_THAT(text.out, HasSubstr(words));
  EXPECT_THAT(text.out, Not(HasSubstr("trunnion_tilt")));
}

TEST(HistoryCall, OfOneRecordOrTwoInstruments) {
  const TemporaryFolder folder;
  const std::string one = recordIn(folder, "2024-01-10", ""), other = recordIn(folder, "2024-02-10", "");
  Json foreign = Json::parse(contentOf(other));
  foreign["serial"] = "9";
  folder.file("2024-02-10.alidade-instrument", foreign.dump());
  EXPECT_THAT(answerTo({one})["instruments"][0]["records"], SizeIs(1));
  EXPECT_TRUE(answerTo({one})["instruments"][0]["quantities"]["collimation"]["stable"].is_null());
  EXPECT_THAT(answerTo({one, other})["instruments"], SizeIs(2));
  expectRefusal(alidadeCli({"history", one, "--baseline", "2"}));
}

TEST(HistoryCall, OfASeriesFileIsThatOfItsSessions) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "sub");
  for (const char* name : {"2025-01-04", "2025-02-05", "2025-03-06"})
    std::filesystem::copy_file(year + "/" + name + ".alidade",
                               folder.path() / "sub" / (std::string(name) + ".alidade"));
  const std::string series =
      folder.file("a b.alidade-series",
                  R"({"format": "alidade-series", "version": 1, "baseline_sessions": 2, "sessions": [
          "sub/2025-01-04.alidade", "sub/2025-02-05.alidade", "sub/2025-03-06.alidade"]})");
  Json json = answerTo({series});
  EXPECT_THAT(json["values"], SizeIs(3));
  EXPECT_EQ(json["chart"]["baseline_values"], 2);
  EXPECT_EQ(answerTo({series, "--baseline", "1"})["chart"]["baseline_values"], 1);
  EXPECT_EQ(json["quantities"]["o1_x"],
            answerTo({(folder.path() / "sub").string(), "--baseline", "2"})["quantities"]["o1_x"]);
  const ProgramRun fits = alidadeCli({"fit", series, "--json", "--no-diagnosis"});
  EXPECT_EQ(std::count(fits.out.begin(), fits.out.end(), '\n'), 3);
  for (const char* bad : {"{", "{}", R"({"format": "alidade-series", "version": 1, "sessions": []})",
                          R"({"format": "alidade-series", "version": 1, "sessions": [7]})",
                          R"({"format": "alidade-series", "version": 9, "sessions": ["a"]})",
                          R"({"format": "alidade-series", "version": 1, "sessions": ["a"],
                              "baseline_sessions": -1})"})
    expectRefusal(alidadeCli({"history", folder.file("bad.alidade-series", bad)}));
}

TEST(HistoryCall, WatchesTheSessionsAfterItsBaseline) {
  const Json json = answerTo({year, "--baseline", "6"});
  EXPECT_EQ(json["chart"]["baseline_values"], 6);
  EXPECT_NEAR(json["chart"]["centre"].get<double>(), 0.212, 0.001);
  EXPECT_EQ(json["quantities"]["radius_0"]["chart"]["baseline_values"], 6);
  EXPECT_EQ(json["tolerance"], 0.5);
  EXPECT_EQ(answerTo({year})["chart"]["baseline_values"], 12);
  const ProgramRun text = alidadeCli({"history", year, "--baseline", "6"});
  EXPECT_THAT(text.out, HasSubstr("Baseline: 6 values from 2025-01-04 to 2025-06-09"));
  EXPECT_THAT(text.out, HasSubstr("Tolerance of the latest session: ± 0.5 mm."));
  EXPECT_THAT(text.out, Not(HasSubstr("standard uncertainty)")));
}

TEST(HistoryCall, RefusesABaselineOfMoreThanThereIs) {
  const TemporaryFolder folder;
  const std::string table = folder.file("c.csv", "2001,10,1\n2002,12,2\n");
  expectRefusal(alidadeCli({"history", table, "--baseline", "3"}));
  expectRefusal(alidadeCli({"history", year, "--baseline", "13"}));
  expectRefusal(alidadeCli({"history", year, "--baseline", "0"}));
  EXPECT_EQ(answerTo({table, "--baseline", "1"})["chart"]["centre"], 10);
  EXPECT_EQ(answerTo({table, "--baseline", "2"})["chart"]["baseline_values"], 2);
}

// The ± of a session is the same in its table and in the chart.
TEST(HistoryCall, HasOneUncertaintyOfASession) {
  const Json json = answerTo({year});
  const ProgramRun fit = alidadeCli({"fit", year + "/2025-01-04.alidade", "--json"});
  EXPECT_NEAR(json["values"][0]["expanded_uncertainty"].get<double>(),
              Json::parse(fit.out)["intersection_measured"]["expanded_mm"].get<double>(), 1e-6);
}

TEST(HistoryCall, IsTextForPeople) {
  const ProgramRun run = alidadeCli({"history", year});
  ASSERT_EQ(run.exitCode, 0);
  EXPECT_THAT(run.out, HasSubstr("From 2025-08-11 on"));
  EXPECT_THAT(run.out, HasSubstr("radius at 180°"));
  EXPECT_THAT(run.out, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace alidade::test
