#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include "core/effects/catalogue.h"
#include "core/session/session_file.h"
#include "core/simulation/protocol.h"
#include "tests/console/console.h"
#include "tests/support/far_off.h"
#include "tests/support/file_content.h"

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;

/// Mutants that the schema accepts, since the removed key depends on the session.
const std::set<std::string> mayBeAbsent = {
    "gone intersection",  // a result without it also lacks everything derived from it
    "gone intersection/as_found",
    "gone decision",
    "gone two_faces",
    "gone two_faces/trunnion_tilt",
    "gone monte_carlo",
    "gone monte_carlo/intersection",
    "gone known",
    "gone what_it_would_take",
    "gone shape",
};

class SchemaTest : public ::testing::Test {
 protected:
  /// The script's verdict on documents, one per line, against a schema of the program.
  std::string against(const std::string& schema, const std::string& documents,
                      const std::vector<std::string>& options = {}) {
    const ProgramRun printed = alidadeCli({"schema", schema});
    EXPECT_EQ(printed.exitCode, 0) << printed.err;
    std::vector<std::string> arguments{ALIDADE_SUPPORT_DIR "/against_schema.py",
                                       m_folder.file(schema + ".json", printed.out),
                                       m_folder.file("documents.jsonl", documents)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = runProgram({.program = "python3", .arguments = arguments});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return run.out;
  }

  static std::string onALine(const std::string& document) { return Json::parse(document).dump() + "\n"; }

  static std::string answer(const std::vector<std::string>& call) {
    const ProgramRun run = alidadeCli(call);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return onALine(run.out);
  }

  static std::vector<std::string> samples() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(ALIDADE_SAMPLES_DIR))
      if (entry.path().extension() == ".alidade") files.push_back(entry.path());
    return files;
  }

  std::string simulated(const std::string& protocol, const std::string& effect) {
    const std::string session = m_folder.path() / "simulated.alidade";
    std::vector<std::string> call{
        "simulate", "--out", session,      "--truth", m_folder.path() / "truth.json",
        "--seed",   "5",     "--protocol", protocol};
    if (!effect.empty()) call.insert(call.end(), {"--effect", effect});
    const ProgramRun run = alidadeCli(call);
    EXPECT_EQ(run.exitCode, 0) << protocol << run.err;
    return session;
  }

  const TemporaryFolder m_folder;
};

TEST_F(SchemaTest, IsMetByTheFitsOfAllSamples) {
  std::string documents;
  for (const std::string& file : samples()) {
    documents += answer({"fit", file, "--json"});
    documents += answer({"fit", file, "--json", "--method", "published"});
  }
  documents += answer({"fit", paperSession, "--json", "--no-diagnosis"});
  documents += answer({"fit", paperSession, "--json", "--monte-carlo", "2000"});
  EXPECT_EQ(against("fit", documents), "");
}

TEST_F(SchemaTest, IsMetByTheDiagnosesOfAllSamplesAndOfTheirSeries) {
  std::string documents;
  for (const std::string& file : samples()) documents += answer({"diagnose", file, "--json"});
  documents += answer({"diagnose", ALIDADE_SAMPLES_DIR "/series", "--json"});
  // Effects outside the catalogue, shared by all sessions.
  const TemporaryFolder series;
  for (const char* seed : {"1", "2", "3", "4"})
    alidadeCli({"simulate", "--protocol", "two-face", "--effect", "settling=40,0.2", "--seed", seed,
                "--instrument-serial", "T-1", "--truth", m_folder.path().string() + "/truth.json", "--out",
                series.path().string() + "/" + seed + ".alidade"});
  const std::string unknown = answer({"diagnose", series.path().string(), "--json"});
  EXPECT_EQ(Json::parse(unknown)["series"]["shape"]["follows"], "orientation settling with time");
  EXPECT_FALSE(Json::parse(unknown)["series"]["offered_effects"].empty());
  documents += unknown;
  const std::string referred = m_folder.file("referred.alidade", changedPaperSession([](Json& session) {
                                               session["acceptance"]["sigma_reference_mm"] = 0.02;
                                             }));
  documents += answer({"diagnose", referred, "--json", "--with-reference"});
  EXPECT_EQ(against("diagnose", documents), "");
}

TEST_F(SchemaTest, IsMetByPlansAndJournals) {
  std::string plans, journals;
  for (const std::string& file : samples()) {
    plans += answer({"plan", file, "--json"});
    journals += answer({"journal", file, "--json"});
  }
  EXPECT_EQ(against("plan", plans), "");
  EXPECT_EQ(against("journal", journals), "");
}

TEST_F(SchemaTest, IsMetByWhateverIsSimulated) {
  std::string fits, diagnoses, sessions, plans;
  const auto add = [&](const std::string& session) {
    fits += answer({"fit", session, "--json"});
    diagnoses += answer({"diagnose", session, "--json"});
    plans += answer({"plan", session, "--json"});
    sessions += onALine(contentOf(session));
  };
  for (const Protocol& protocol : namedProtocols()) add(simulated(std::string(protocol.name), ""));
  for (const Effect& effect : effectCatalogue()) {
    std::string sizes;
    for (const EffectParameter& number : effect.parameters)
      sizes += (sizes.empty() ? "=" : ",") + std::to_string(3 * number.plausible);
    add(simulated("two-face", std::string(effect.id) + sizes));
  }
  EXPECT_EQ(against("fit", fits), "");
  EXPECT_EQ(against("diagnose", diagnoses), "");
  EXPECT_EQ(against("plan", plans), "");
  EXPECT_EQ(against("session", sessions), "");
}

// Schemas include ranges: readings far from any arc give a result within them, or an error message.
TEST_F(SchemaTest, IsMetByWhateverLiesFarOffAnyArc) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 140; ++seed)
    folder.file(std::to_string(seed) + ".alidade", writeSession(FarOffSession(seed).session()));
  const std::string path = folder.path().string();
  const ProgramRun fits = alidadeCli({"fit", path, "--json"});
  EXPECT_GT(std::ranges::count(fits.out, '\n'), 100);
  EXPECT_THAT(fits.out, ::testing::HasSubstr("\"intersection\""));
  EXPECT_EQ(against("fit", fits.out), "");
  EXPECT_EQ(against("fit", alidadeCli({"fit", path, "--json", "--method", "published"}).out), "");
  EXPECT_EQ(against("diagnose", alidadeCli({"diagnose", "--each", path, "--json"}).out), "");
}

// A result of many files names each file, and states why one is unusable.
TEST_F(SchemaTest, IsMetByEachLineOfManyAnswers) {
  const std::string broken = m_folder.file("broken.alidade", "{}");
  const std::string onePosition = m_folder.file("one.alidade", changedPaperSession([](Json& session) {
                                                  session["positions"].erase(1);
                                                  session["acceptance"].erase("tolerance_mm");
                                                }));
  const std::string again = m_folder.file("again.alidade", changedPaperSession([](Json& session) {
                                            session["positions"].push_back(session["positions"][0]);
                                          }));
  const ProgramRun fits = alidadeCli({"fit", broken, onePosition, again, paperSession, "--json"});
  EXPECT_EQ(std::ranges::count(fits.out, '\n'), 4);
  EXPECT_THAT(fits.out, ::testing::HasSubstr("\"error\""));
  EXPECT_EQ(against("fit", fits.out), "");
  const ProgramRun diagnoses =
      alidadeCli({"diagnose", "--each", broken, onePosition, again, paperSession, "--json"});
  EXPECT_EQ(against("diagnose", diagnoses.out), "");
}

TEST_F(SchemaTest, RefusesWhatIsSpoiltInAnyPlace) {
  const auto refusals = [&](const std::string& schema, const std::string& documents) {
    const std::string passed = against(schema, documents, {"--mutated"});
    std::istringstream lines(passed);
    std::string line, last;
    while (std::getline(lines, line)) {
      const bool isCount = line.find(' ') == std::string::npos;
      if (isCount) last = line;
      const bool isOfTheEntry =
          line.starts_with("gone ") && (line.ends_with("/sizes") || line.ends_with("/reference") ||
                                        line.ends_with("/axis_deg") || line.ends_with("/date"));
      EXPECT_TRUE(isCount || isOfTheEntry || mayBeAbsent.contains(line)) << schema << ": " << line;
    }
    return std::stoi(last);
  };
  EXPECT_GT(refusals("fit", answer({"fit", paperSession, "--json", "--no-diagnosis"})), 300);
  EXPECT_GT(refusals("fit", answer({"fit", paperSession, "--json", "--method", "published"})), 50);
  EXPECT_GT(refusals("diagnose", answer({"diagnose", paperSession, "--json"})), 300);
  EXPECT_GT(refusals("plan", answer({"plan", paperSession, "--json"})), 50);
}

// Any typed text is accepted; required keys must be present.
TEST_F(SchemaTest, OfTheSessionAsksForWhatTheProgramAsksForAndLetsTheRestBe) {
  const auto accepts = [&](const std::function<void(Json&)>& change) {
    return against("session", onALine(changedPaperSession(change))).empty();
  };
  EXPECT_TRUE(accepts([](Json& session) { session["further"] = {{"key", 1}}; }));
  EXPECT_TRUE(accepts([](Json& session) { session["geometry"]["distance_mm"] = "about 2 m"; }));
  EXPECT_TRUE(accepts([](Json& session) { session["positions"][0]["readings"][0]["vertical"] = 90.5; }));
  for (const char* key : {"format", "version", "geometry", "positions"})
    EXPECT_FALSE(accepts([&](Json& session) { session.erase(key); })) << key;
  for (const char* key : {"distance_mm", "radius_mm"})
    EXPECT_FALSE(accepts([&](Json& session) { session["geometry"].erase(key); })) << key;
  for (const char* key : {"axis_deg", "pointing_zero"})
    EXPECT_FALSE(accepts([&](Json& session) { session["positions"][1].erase(key); })) << key;
  for (const char* key : {"horizontal", "vertical"}) {
    EXPECT_FALSE(accepts([&](Json& session) { session["positions"][0]["readings"][3].erase(key); })) << key;
    EXPECT_FALSE(accepts([&](Json& session) { session["positions"][0]["pointing_zero"].erase(key); })) << key;
  }
  EXPECT_FALSE(accepts([](Json& session) { session["version"] = 2; }));
  EXPECT_FALSE(accepts([](Json& session) { session["positions"][0]["readings"][0]["excluded"] = "no"; }));
  EXPECT_FALSE(accepts([](Json& session) { session["title"] = 7; }));
}

std::vector<std::string> commandsWithJson() {
  std::vector<std::string> commands;
  std::istringstream help(alidadeCli({"--help"}).out);
  std::string line;
  while (std::getline(help, line) && line != "Subcommands:") continue;
  while (std::getline(help, line) && line.starts_with("  ")) {
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    if (alidadeCli({name, "--help"}).out.find("--json") != std::string::npos) commands.push_back(name);
  }
  return commands;
}

TEST(Schema, IsThereForEveryAnswer) {
  const std::vector<std::string> commands = commandsWithJson();
  EXPECT_THAT(commands, ::testing::IsSupersetOf({"fit", "diagnose", "history", "instrument", "self-test"}));
  std::set<std::string> ids;
  for (const std::string& command : commands) {
    const ProgramRun run = alidadeCli({"schema", command});
    ASSERT_EQ(run.exitCode, 0) << command << run.err;
    const Json schema = Json::parse(run.out);
    EXPECT_EQ(schema["$id"], "urn:alidade:schema:" + command + ":1");
    EXPECT_EQ(schema["title"], "alidade-cli " + command + " --json");
    ids.insert(schema["$id"].get<std::string>());
  }
  EXPECT_EQ(ids.size(), commands.size());
  EXPECT_EQ(Json::parse(alidadeCli({"schema", "session"}).out)["$id"], "urn:alidade:schema:session:1");
}

TEST_F(SchemaTest, IsMetByHistories) {
  const std::string months = ALIDADE_SAMPLES_DIR "/history", series = ALIDADE_SAMPLES_DIR "/series";
  const std::string one = m_folder.file("one.csv", "2001,1,0.1\n"),
                    step = m_folder.file("step.csv",
                                         "date,value (mm),u\n2001,1,0.1\n2002,1.1,0.1\n2003,1,0.1\n"
                                         "2004,3,0.1\n2005,3.1,0.1\n2006,3,0.1\n"),
                    day = m_folder.file("day.csv", "2001,1,0.1\n2001,1,0.1\n2001,9,0.1\n");
  std::string documents;
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{months}, {months, "--baseline", "5"}, {series}, {one}, {step}, {day}}) {
    std::vector<std::string> whole{"history", "--json"};
    whole.insert(whole.end(), call.begin(), call.end());
    documents += answer(whole);
  }
  documents += alidadeCli({"history", "--json", one, m_folder.file("bad.csv", "x"), step}).out;
  const TemporaryFolder records;
  for (const char* date : {"2024-01-10", "2025-01-12"})
    alidadeCli({"instrument", ALIDADE_SAMPLES_DIR "/instrument-check.gsi", "--date", date, "--record",
                records.path().string() + "/" + date + ".alidade-instrument"});
  documents += answer({"history", records.path().string(), "--json"});
  EXPECT_EQ(against("history", documents), "");
  EXPECT_EQ(against("history", answer({"history", one, "--json"}), {"--mutated"}).find("misspelt"),
            std::string::npos);
}

TEST_F(SchemaTest, IsMetByChecksProtocolsTrialsFormsAndReports) {
  std::string checks, guidances, blind;
  for (const char* sigma : {"0.3", "1"})
    checks += answer({"instrument", ALIDADE_SAMPLES_DIR "/instrument-check.gsi", "--json", "--sigma", sigma});
  checks += answer({"instrument", ALIDADE_SAMPLES_DIR "/instrument-check.gsi", "--json"});
  for (const char* name :
       {"check-directions-alone.csv", "check-two-distances.csv", "check-stations-unnamed.csv"})
    if (const ProgramRun run =
            alidadeCli({"instrument", std::string(ALIDADE_REFERENCE_DIR "/import/") + name, "--json"});
        run.exitCode == 0)
      checks += onALine(run.out);
  EXPECT_EQ(against("instrument", checks), "");
  for (const char* order : {"listed", "by-worth"})
    guidances +=
        answer({"protocol", paperSession, "--json", "--template", "there-and-back", "--order", order});
  EXPECT_EQ(against("protocol", guidances), "");
  blind += answer({"trial", "--count", "3", "--seed", "3", "--json"});
  blind += answer({"trial", "--series", "1", "--seed", "7", "--json"});
  EXPECT_EQ(against("trial", blind), "");
  std::string table = "residual_arcsec,sigma_arcsec,circle,azimuth_deg,elevation_deg\n";
  for (int i = 0; i < 90; ++i)
    table += std::to_string(8 * std::cos(i * 0.2)) + ",1,horizontal," + std::to_string(4 * i) + ",5\n";
  EXPECT_EQ(against("discover", answer({"discover", m_folder.file("table.csv", table), "--json"})), "");
  EXPECT_EQ(against("self-test", onALine(alidadeCli({"self-test", "--json"}).out)), "");
  const std::string session = m_folder.file("s.alidade", contentOf(paperSession));
  EXPECT_EQ(against("report", alidadeCli({"report", session, "none.alidade", "--json"}).out), "");
}

TEST(Schema, IsAskedForByName) {
  expectRefusal(alidadeCli({"schema", "fits"}));
  EXPECT_THAT(alidadeCli({"schema", "fits"}).err, ::testing::HasSubstr("session"));
}

}  // namespace
}  // namespace alidade::test
