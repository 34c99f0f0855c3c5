#include <gmock/gmock.h>

#include <filesystem>

#include "tests/console/console.h"

// Bad input and bad calls: one line that says what, where and what to do; exit code 2; empty stdout.

namespace alidade::test {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

/// The refusal of a changed session by `fit`, after checking and removing the file's path and the colon.
std::string refusalOf(const std::string& content) {
  const TemporaryFolder folder;
  const std::string file = folder.file("bad.alidade", content);
  const ProgramRun run = alidadeCli({"fit", file, "--json"});
  expectRefusal(run);
  EXPECT_THAT(run.err, StartsWith(file + ": "));
  return run.err.substr(std::min(run.err.size(), file.size() + 2));
}

TEST(Refusal, NamesAMissingFile) {
  const ProgramRun run = alidadeCli({"fit", "no-such-file.alidade"});
  expectRefusal(run);
  EXPECT_THAT(run.err, StartsWith("no-such-file.alidade: "));
}

TEST(Refusal, NamesAFolderGivenAsAFile) {
  const TemporaryFolder folder;
  expectRefusal(alidadeCli({"fit", folder.path().string()}));
}

TEST(Refusal, NamesLineAndColumnOfBrokenJson) {
  EXPECT_THAT(refusalOf("{\n  \"format\": \"alidade-session\",\n  \"version\" 1\n}"), HasSubstr("line 3"));
  refusalOf("");
}

TEST(Refusal, NamesAnotherFormatAndANewerVersion) {
  EXPECT_THAT(refusalOf("{\"format\": \"theodolite-log\", \"version\": 1}"), HasSubstr("format"));
  EXPECT_THAT(refusalOf(changedPaperSession([](Json& session) { session["version"] = 2; })),
              HasSubstr("version"));
}

TEST(Refusal, NamesThePlaceOfAWrongAngle) {
  const std::string refusal = refusalOf(changedPaperSession(
      [](Json& session) { session["positions"][1]["readings"][3]["vertical"] = "88°71'49\""; }));
  EXPECT_THAT(refusal, StartsWith("positions[1].readings[3].vertical: "));
  EXPECT_THAT(refusal, HasSubstr("71"));
}

TEST(Refusal, CountsTheProblemsBehindTheFirst) {
  const std::string refusal = refusalOf(changedPaperSession([](Json& session) {
    session["positions"][0]["readings"][1]["horizontal"] = "north";
    session["positions"][0]["readings"][2]["vertical"] = "up";
    session["positions"][1]["pointing_zero"]["vertical"] = "level";
  }));
  EXPECT_THAT(refusal, StartsWith("positions[0].readings[1].horizontal: "));
  EXPECT_THAT(refusal, EndsWith("(and 2 more)\n"));
}

TEST(Refusal, NamesAMissingAndAMistypedValue) {
  EXPECT_THAT(refusalOf(changedPaperSession([](Json& session) { session["geometry"].erase("distance_mm"); })),
              HasSubstr("geometry.distance_mm"));
  EXPECT_THAT(refusalOf(changedPaperSession([](Json& session) { session["geometry"]["radius_mm"] = true; })),
              HasSubstr("geometry.radius_mm"));
  EXPECT_THAT(refusalOf(changedPaperSession([](Json& session) { session["geometry"]["distance_mm"] = -5; })),
              HasSubstr("geometry.distance_mm"));
}

TEST(Refusal, SaysWhyAnArcCannotBeFitted) {
  const std::string refusal = refusalOf(changedPaperSession([](Json& session) {
    Json& readings = session["positions"][1]["readings"];
    readings.erase(readings.begin() + 2, readings.end());
  }));
  EXPECT_THAT(refusal, StartsWith("positions[1]"));
  EXPECT_THAT(refusal, HasSubstr("180°"));
}

TEST(Refusal, KeepsToOneLineWhateverTheFileHolds) {
  refusalOf(changedPaperSession([](Json& session) { session["geometry"]["distance_mm"] = "24\n05\r\nmm"; }));
}

TEST(Refusal, OfACallNamesWhatIsWrong) {
  const auto refusal = [](std::vector<std::string> arguments) {
    const ProgramRun run = alidadeCli(std::move(arguments));
    expectRefusal(run);
    return run.err;
  };
  EXPECT_THAT(refusal({}), HasSubstr("subcommand"));
  EXPECT_THAT(refusal({"guess"}), HasSubstr("guess"));
  EXPECT_THAT(refusal({"fit"}), HasSubstr("FILE"));
  EXPECT_THAT(refusal({"fit", paperSession, "--fast"}), HasSubstr("--fast"));
  EXPECT_THAT(refusal({"fit", paperSession, "--method", "lucky"}), HasSubstr("lucky"));
  EXPECT_THAT(refusal({"plan", paperSession, paperSession}), HasSubstr("paper-table-1.alidade"));
  EXPECT_THAT(refusal({"fit", paperSession, "--risk", "nan"}), HasSubstr("--risk: “nan” is not a number"));
  EXPECT_THAT(refusal({"fit", paperSession, "--risk", "2"}), HasSubstr("from 1e-09 to 0.5"));
}

// An empty value may come from an unset variable of a script: the option must not be ignored silently.
TEST(Refusal, OfAnEmptyValueAtAnyOption) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"certificate", paperSession, "--measured-on", "2026-01-02", "--out", out,
                                 "--sign-key", "", "--sign-certificate", ""},
        {"certificate", paperSession, "--measured-on", "2026-01-02", "--out", out, "--sign-key="},
        {"certificate", paperSession, "--measured-on", "2026-01-02", "--out", out, "--pdf", ""},
        {"fit", paperSession, "--instrument", ""},
        {"protocol", paperSession, "--template", "full", "--out", ""},
        {"protocol", paperSession, "--template", "full", "--save-template="},
        {"trial", "--score", ""},
        {"self-test", "--fits", ""}}) {
    const ProgramRun run = alidadeCli(call);
    expectRefusal(run);
    EXPECT_THAT(run.err, ::testing::ContainsRegex("alidade-cli: --[a-z-]+ is given an empty value: "));
    EXPECT_FALSE(std::filesystem::exists(out));
  }
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"fit", ""}, {"fit", paperSession, ""}, {""}}) {
    const ProgramRun run = alidadeCli(call);
    expectRefusal(run);
    EXPECT_THAT(run.err, HasSubstr("argument " + std::to_string(call.size()) + " is empty: "));
  }
}

// A seed interpreted as another one would give a session that its stated seed cannot reproduce.
TEST(Refusal, OfASeedThatIsNone) {
  for (const char* seed : {"-1", "99999999999999999999", "1.5", "0x10", "nan"}) {
    for (const std::vector<std::string>& call :
         {std::vector<std::string>{"fit", paperSession, "--monte-carlo", "1000"},
          {"trial", "--count", "1"},
          {"simulate", "--out", "/no/such/folder/s", "--truth", "/no/such/folder/t"}}) {
      std::vector<std::string> arguments = call;
      arguments.insert(arguments.end(), {"--seed", seed});
      const ProgramRun run = alidadeCli(arguments);
      expectRefusal(run);
      EXPECT_THAT(run.err, HasSubstr("--seed: ")) << call.front() << " " << seed;
    }
  }
}

}  // namespace
}  // namespace alidade::test
