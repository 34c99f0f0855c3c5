#include <gmock/gmock.h>

#include <filesystem>

#include "tests/console/console.h"
#include "tests/support/file_content.h"

// `alidade-cli import`: a session from a file of readings, with missing parts reported on stderr.

namespace alidade::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

const std::string paperTable = ALIDADE_REFERENCE_DIR "/paper-table-1.csv";

class ImportTest : public ::testing::Test {
 protected:
  ProgramRun import(const std::string& file, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"import", file, "--out", session});
    return alidadeCli(std::move(more));
  }
  Json fit() const { return Json::parse(alidadeCli({"fit", session, "--json"}).out); }

  TemporaryFolder folder;
  std::string session = (folder.path() / "s.alidade").string();
};

TEST_F(ImportTest, PapersTableFitsAsTheSampleDoes) {
  const ProgramRun run = import(paperTable, {"--distance", "2405", "--sigma-distance", "1.0", "--radius",
                                             "400", "--tolerance", "2.5", "--zero-0", "332-32-54", "89-59-57",
                                             "--zero-180", "332-32-50", "89-59-58", "--title", "Table I"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("34 rows from CSV (17 at 0°, 17 at 180°)"));
  EXPECT_THAT(run.err, IsEmpty());
  const Json result = fit(), sample = Json::parse(alidadeCli({"fit", paperSession, "--json"}).out);
  for (const char* part : {"session", "arcs", "intersection", "decision", "budget", "suspects"})
    EXPECT_EQ(result.at(part).dump(), sample.at(part).dump());
}

TEST_F(ImportTest, SaysWhatIsStillToBeTyped) {
  const std::string gsi =
      folder.file("arc.gsi", "110001+00000001 21.322+37985926 22.322+09808000 31..00+00002405\n");
  const ProgramRun run = import(gsi);
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_THAT(run.out, HasSubstr("1 row from GSI-8"));
  for (const char* part : {"slope distance", "geometry.distance_mm", "geometry.radius_mm", "pointing_zero"})
    EXPECT_THAT(run.err, HasSubstr(part));
  const Json written = Json::parse(contentOf(session));
  EXPECT_EQ(written["title"], "arc");
  EXPECT_EQ(written["positions"][0]["readings"][0]["horizontal"], "379.85926gon");
}

TEST_F(ImportTest, TakesUnitsAndCircleFromTheOptions) {
  const std::string csv = folder.file("a.csv", "axis;Hz;V\n0;379,8;2,5\n0;380,1;3,5\n0;380,2;-2,5\n");
  const ProgramRun run = import(csv, {"--unit", "gon", "--vertical-circle", "elevation", "--distance", "2405",
                                      "--radius", "400", "--zero-0", "379,5", "0", "--sigma", "1.5"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  const Json written = Json::parse(contentOf(session));
  EXPECT_EQ(written["positions"][0]["readings"][0]["horizontal"], "379,8gon");
  EXPECT_EQ(written["positions"][0]["pointing_zero"]["horizontal"], "379,5gon");
  EXPECT_EQ(written["geometry"]["vertical_circle"], "elevation");
  EXPECT_EQ(written["instrument"]["sigma_vertical_arcsec"], 1.5);
}

// −10′ is a valid elevation but an invalid zenith angle; the column name states the kind of circle.
TEST_F(ImportTest, ChecksTheZeroByTheCircleThatTheTableNames) {
  const std::string elevations = folder.file("e.csv", "axis,Hz,elevation\n0,341°,2°\n");
  EXPECT_EQ(import(elevations, {"--zero-0", "341°", "-0°10'"}).exitCode, 0);
  const std::string zenith = folder.file("z.csv", "axis,Hz,zenith\n0,341°,88°\n");
  const ProgramRun run = import(zenith, {"--zero-0", "341°", "-0°10'", "--vertical-circle", "elevation"});
  expectRefusal(run);
  EXPECT_THAT(run.err, HasSubstr("--zero-0: “-0°10'” lies outside 0°…360°"));
}

TEST_F(ImportTest, NamesFileLineAndColumn) {
  const std::string csv =
      folder.file("bad.csv", "Hz,V\n341°52'24\",88°16'49\"\n341°52'24\",88°71'49\"\n1,2\n");
  const ProgramRun run = import(csv);
  expectRefusal(run);
  EXPECT_THAT(run.err, StartsWith(csv + ": line 3, column 12: vertical “88°71'49\"” has 71 minutes"));
  EXPECT_FALSE(std::filesystem::exists(session));
}

TEST_F(ImportTest, RefusesWhatCannotBeDone) {
  const auto refusal = [](const ProgramRun& run) {
    expectRefusal(run);
    return run.err;
  };
  EXPECT_THAT(refusal(import("nothing.gsi")), StartsWith("nothing.gsi: cannot be opened"));
  EXPECT_THAT(refusal(import(paperTable, {"--distance", "far"})),
              HasSubstr("--distance: “far” is not a number"));
  EXPECT_THAT(refusal(import(paperTable, {"--zero-0", "332-32-54", "89-71-57"})), HasSubstr("--zero-0"));
  EXPECT_THAT(refusal(import(paperSession)), HasSubstr("open it as a session"));
  EXPECT_THAT(refusal(alidadeCli({"import", paperTable})), HasSubstr("--out"));
  EXPECT_THAT(refusal(alidadeCli({"import", paperTable, "--out", "/no/such/folder/s.alidade"})),
              HasSubstr("cannot be written"));
}

TEST_F(ImportTest, NamesFormatsThatAreNotRead) {
  for (const auto& [file, name] :
       {std::pair("survce.rw5", "Carlson RW5"), std::pair("nikon.raw", "Nikon RAW"),
        std::pair("table.xlsx", "XLSX"), std::pair("job.dbx", "Leica DBX")}) {
    const std::string path = std::string(ALIDADE_REFERENCE_DIR "/import/named/") + file;
    for (const ProgramRun& run : {import(path), alidadeCli({"instrument", path})}) {
      expectRefusal(run);
      EXPECT_THAT(run.err, HasSubstr("is a file of the format "));
      EXPECT_THAT(run.err, HasSubstr(name));
    }
  }
  EXPECT_FALSE(std::filesystem::exists(session));
}

TEST_F(ImportTest, ReadsTheFormatsThatItsHelpLists) {
  for (const char* command : {"import", "instrument"})
    EXPECT_THAT(alidadeCli({command, "--help"}).out,
                HasSubstr("Trimble JobXML, LandXML (HeXML), and tables."));
  const ProgramRun run = import(ALIDADE_REFERENCE_DIR "/import/read/access.jxl");
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("3 rows from JobXML"));
  EXPECT_THAT(run.err, HasSubstr("a mean of observations (MeanTurnedAngle) is not used: line 34"));
}

TEST_F(ImportTest, NeverWritesOverTheFileItReads) {
  const std::string csv = folder.file("a.csv", "Hz,V\n341°,88°\n");
  const std::string sameFile = (folder.path() / "." / "a.csv").string();
  expectRefusal(alidadeCli({"import", csv, "--out", sameFile}));
  const std::string hard = (folder.path() / "hard.csv").string();
  std::filesystem::create_hard_link(csv, hard);
  expectRefusal(alidadeCli({"import", csv, "--out", hard}));
  const ProgramRun run =
      runProgram({.program = "/bin/sh",
                  .arguments = {"-c", "exec \"$0\" import - --out \"$1\" < \"$1\"", ALIDADE_CLI, csv}});
  expectRefusal(run);
  EXPECT_THAT(run.err, HasSubstr("this is the file being read: choose another name"));
  EXPECT_THAT(contentOf(csv), StartsWith("Hz,V"));
}

const std::string plain = "1;341.5224;88.1649\n2;341.2601;86.4124\n";

TEST_F(ImportTest, TakesSeveralFilesWithTheirPositionsAndRounds) {
  const std::string a = folder.file("a.csv", "point,Hz,V\n1,341°,88°\n"),
                    b = folder.file("b.csv", "point,Hz,V\n1,341°,91°\n");
  const ProgramRun run =
      alidadeCli({"import", a, b, a, "--axis", "0,180,0", "--round", "-,-,2", "--out", session});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("3 rows from CSV (2 at 0°, 1 at 180°)"));
  const Json written = Json::parse(contentOf(session));
  EXPECT_EQ(written["positions"][0]["readings"][1]["round"], 2);
  ASSERT_EQ(written["journal"].size(), 3u);
  EXPECT_THAT(written["journal"][2]["to"].get<std::string>(),
              HasSubstr("“b.csv”, line 2: 1 row from row 1 on; SHA-256 "));
  EXPECT_THAT(alidadeCli({"journal", session}).out,
              ContainsRegex("\n +2[0-9: -]+positions.1..readings +imported +“b\\.csv”, line 2"));
  expectRefusal(alidadeCli({"import", a, b, "--axis", "0", "--out", session}));
  expectRefusal(alidadeCli({"import", a, "--axis", "90", "--out", session}));
}

TEST_F(ImportTest, TakesATableWithoutNames) {
  const std::string table = folder.file("a.txt", plain);
  expectRefusal(import(table));
  const ProgramRun run = import(table, {"--columns", "point,horizontal,vertical", "--head-rows", "0",
                                        "--unit", "dms", "--axis", "180"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  const Json written = Json::parse(contentOf(session));
  EXPECT_EQ(written["positions"][0]["axis_deg"], 180);
  EXPECT_EQ(written["positions"][0]["readings"][0]["horizontal"], "341 52 24");
  expectRefusal(import(table, {"--columns", "point,colour,vertical"}));
  expectRefusal(import(table, {"--columns", "point,horizontal,vertical", "--head-rows", "0", "--unit", "dms",
                               "--decimal", "comma"}));
}

TEST_F(ImportTest, AddsToASession) {
  const std::string more = folder.file("more.csv", "point,Hz,V\n1,341°,88°\n");
  const ProgramRun run = import(more, {"--add-to", paperSession, "--axis", "0", "--round", "2"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  const Json written = Json::parse(contentOf(session)), paper = Json::parse(contentOf(paperSession));
  EXPECT_EQ(written["positions"][0]["readings"].size(), paper["positions"][0]["readings"].size() + 1);
  EXPECT_EQ(written["positions"][1].dump(), paper["positions"][1].dump());
  EXPECT_EQ(written["title"], paper["title"]);
  expectRefusal(alidadeCli({"import", more, "--add-to", session, "--out", session}));
}

TEST_F(ImportTest, ReadsFilesOfTrimbleAndSokkia) {
  const std::string m5 =
      folder.file("a.m5",
                  "For M5|Adr 00001|PI1                           2|                      |Hz "
                  "        7.5439 DMS |V1        89.1413 DMS | \r\n");
  EXPECT_THAT(import(m5, {"--axis", "0"}).out, HasSubstr("1 row from M5"));
  const std::string sdr =
      folder.file("a.sdr",
                  "00NMSDR33 V04-04.02 000004-Oct-26 10:00 211111\r\n09F1ST1             101        "
                  "                     101.23450000    87.43210000\r\n");
  EXPECT_THAT(import(sdr, {"--axis", "0"}).out, HasSubstr("1 row from SDR33"));
  EXPECT_EQ(Json::parse(contentOf(session))["positions"][0]["readings"][0]["vertical"], "101.23450000gon");
}

TEST_F(ImportTest, ReadsStandardInput) {
  const ProgramRun run = runProgram({.program = ALIDADE_CLI,
                                     .arguments = {"import", "-", "--out", session},
                                     .input = "axis,Hz,V\n0,341°,88°\n"});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_THAT(run.err, Not(HasSubstr("assigned to 0°")));
}

}  // namespace
}  // namespace alidade::test
