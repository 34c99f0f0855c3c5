#include <gmock/gmock.h>

#include <filesystem>
#include <set>

#include "tests/console/console.h"

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;

/// Keys that may be absent although they are there: each depends on the session.
const std::set<std::string> mayBeAbsent = {
    "gone intersection",  // with all that rests on it, another mutant
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
  /// What the script says of documents, one a line, against a schema of the program's.
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
    std::vector<std::string> call{"simulate", "--out",      session, "--truth", m_folder.path() / "truth.json",
                                  "--seed",   "5",          "--protocol", protocol};
    if (!effect.empty()) call.insert(call.end(), {"--effect", effect});
    const ProgramRun run = alidadeCli(call);
    EXPECT_EQ(run.exitCode, 0) << protocol << run.err;
    return session;
  }

  const TemporaryFolder m_folder;
};

TEST_F(SchemaTest, IsMetByTheFitsOfAllSamples) {
  std::string documents;
  for (const std::string& sample : samples()) {
    documents += answer({"fit", sample, "--json"});
    documents += answer({"fit", sample, "--json", "--method", "published"});
  }
  documents += answer({"fit", paperSession, "--json", "--no-diagnosis"});
  documents += answer({"fit", paperSession, "--json", "--monte-carlo", "2000"});
  EXPECT_EQ(against("fit", documents), "");
}

TEST_F(SchemaTest, IsMetByTheDiagnosesOfAllSamplesAndOfTheirSeries) {
  std::string documents;
  for (const std::string& sample : samples()) documents += answer({"diagnose", sample, "--json"});
  documents += answer({"diagnose", ALIDADE_SAMPLES_DIR "/series", "--json"});
  documents += answer({"diagnose", paperSession, "--json", "--with-reference"});
  EXPECT_EQ(against("diagnose", documents), "");
}

TEST_F(SchemaTest, IsMetByPlansAndJournals) {
  std::string plans, journals;
  for (const std::string& sample : samples()) {
    plans += answer({"plan", sample, "--json"});
    journals += answer({"journal", sample, "--json"});
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
  for (const char* protocol : {ALIDADE_PROTOCOLS}) add(simulated(protocol, ""));
  for (const char* effect : {ALIDADE_EFFECTS}) add(simulated("full", effect));
  EXPECT_EQ(against("fit", fits), "");
  EXPECT_EQ(against("diagnose", diagnoses), "");
  EXPECT_EQ(against("plan", plans), "");
  EXPECT_EQ(against("session", sessions), "");
}
