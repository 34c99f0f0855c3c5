#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <sstream>

#include "app/console/batch.h"
#include "app/console/session_files.h"
#include "tests/console/console.h"

// Many files: one result each in input order, independent of the others.

namespace alidade::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

std::string titled(const std::string& title) {
  return changedPaperSession([&](Json& session) { session["title"] = title; });
}

std::vector<Json> linesOf(const std::string& text) {
  std::vector<Json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(Json::parse(line));
  return lines;
}

std::vector<std::string> pathsOf(const console::SessionFiles& list) {
  std::vector<std::string> paths;
  for (const console::ListedFile& file : list.files) paths.push_back(file.path);
  return paths;
}

TEST(Batch, GivesALineForEachFileInTheirOrder) {
  const TemporaryFolder folder;
  std::vector<std::string> call = {"fit", "--no-diagnosis", "--json", "--threads", "4"};
  for (int i = 0; i < 40; ++i)
    call.push_back(folder.file(std::to_string(i), titled("no " + std::to_string(i))));
  const ProgramRun run = alidadeCli(call);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const std::vector<Json> lines = linesOf(run.out);
  ASSERT_EQ(lines.size(), 40u);
  for (int i = 0; i < 40; ++i) {
    EXPECT_EQ(lines[i]["session"], "no " + std::to_string(i));
    EXPECT_EQ(lines[i].begin().key(), "file");
    EXPECT_EQ(lines[i]["file"], call[5 + i]);
  }
}

TEST(Batch, GivesALineForASingleFileOnRequest) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.alidade", titled("a"));
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"fit", "--json-lines", path}, {"diagnose", "--json-lines", path}}) {
    const ProgramRun run = alidadeCli(call);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const std::vector<Json> lines = linesOf(run.out);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0]["file"], path);
    EXPECT_EQ(lines[0]["session"], "a");
  }
}

// An answer says of which bytes it is: their SHA-256, as `sha256sum` prints it.
TEST(Batch, NamesTheBytesOfTheSession) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.alidade", titled("a"));
  const ProgramRun sum = runProgram({.program = "/usr/bin/sha256sum", .arguments = {path}});
  ASSERT_EQ(sum.exitCode, 0) << sum.err;
  for (const char* command : {"fit", "diagnose", "plan", "journal"}) {
    const ProgramRun run = alidadeCli({command, "--json", path});
    EXPECT_EQ(Json::parse(run.out)["session_sha256"], sum.out.substr(0, 64)) << command << run.err;
  }
}

TEST(Batch, SaysOfEachFileWhatIsSaidOfItAlone) {
  const TemporaryFolder folder;
  folder.file("a.alidade", titled("a"));
  folder.file("b.alidade", titled("b"));
  for (const std::vector<std::string>& call : {std::vector<std::string>{"fit"}, {"diagnose", "--each"}}) {
    std::vector<std::string> many = call;
    many.insert(many.end(), {folder.path().string(), "--json"});
    const ProgramRun run = alidadeCli(many);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    std::vector<Json> lines = linesOf(run.out);
    ASSERT_EQ(lines.size(), 2u);
    for (Json& line : lines) {
      const std::string file = line["file"];
      line.erase("file");
      EXPECT_EQ(line, Json::parse(alidadeCli({call.front(), file, "--json"}).out));
    }
  }
}

// Reading a pipe or a device may block forever, so a folder never opens one.
TEST(Batch, NamesWhatIsNoFileInAFolder) {
  const TemporaryFolder folder;
  const std::string session = folder.file("2.alidade", titled("second"));
  const std::string pipe = folder.path() / "1.alidade", device = folder.path() / "3.alidade",
                    link = folder.path() / "4.alidade", lost = folder.path() / "5.alidade";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", device);
  std::filesystem::create_symlink(session, link);
  std::filesystem::create_symlink("nowhere", lost);
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"fit", "--no-diagnosis"}, {"diagnose", "--each"}}) {
    std::vector<std::string> whole = call;
    whole.insert(whole.end(), {folder.path().string(), "--json"});
    const ProgramRun run = alidadeCli(whole);
    EXPECT_EQ(run.exitCode, 2);
    const std::vector<Json> lines = linesOf(run.out);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_THAT(lines[0]["error"], StartsWith("is a pipe, a socket or a device"));
    EXPECT_EQ(lines[1]["session"], "second");
    EXPECT_EQ(lines[2]["file"], device);
    EXPECT_THAT(lines[2]["error"], StartsWith("is a pipe, a socket or a device"));
    EXPECT_THAT(lines[3]["error"], HasSubstr("cannot be opened"));
  }
}

TEST(Batch, ReadsAPipeThatIsNamedByItself) {
  const TemporaryFolder folder;
  const std::string session = folder.file("a.alidade", titled("through a pipe"));
  const ProgramRun run = runProgram(
      {.program = "/bin/bash",
       .arguments = {"-c", "exec \"$0\" fit --no-diagnosis --json <(cat \"$1\")", ALIDADE_CLI, session}});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out)["session"], "through a pipe");
}

// Δd of the paper is 1.24 ± 0.79 mm.
TEST(Batch, ExitsWithTheVerdictOnRequest) {
  const TemporaryFolder folder;
  const auto within = [&](const char* name, double tolerance) {
    return folder.file(
        name, changedPaperSession([&](Json& session) { session["acceptance"]["tolerance_mm"] = tolerance; }));
  };
  const std::string accepted = within("a.alidade", 2.5), rejected = within("r.alidade", 0.05),
                    undecided = within("u.alidade", 1.5);
  const std::string none = folder.file(
      "n.alidade", changedPaperSession([](Json& session) { session["acceptance"].erase("tolerance_mm"); }));
  const auto exitOf = [](std::vector<std::string> files) {
    files.insert(files.begin(), {"fit", "--verdict-exit"});
    return alidadeCli(files).exitCode;
  };
  EXPECT_EQ(exitOf({accepted}), 0);
  EXPECT_EQ(exitOf({rejected}), 3);
  EXPECT_EQ(exitOf({undecided}), 4);
  EXPECT_EQ(exitOf({none}), 4);
  EXPECT_EQ(exitOf({accepted, undecided}), 4);
  EXPECT_EQ(exitOf({undecided, rejected, accepted}), 3);
  EXPECT_EQ(exitOf({accepted, "/no/such.alidade"}), 2) << "an unusable file is no verdict";
  EXPECT_EQ(alidadeCli({"fit", rejected}).exitCode, 0) << "only on request";
  expectRefusal(alidadeCli({"fit", "--verdict-exit", "--method", "published", accepted}));
}

TEST(Batch, GoesOnBehindABadFile) {
  const TemporaryFolder folder;
  const std::string first = folder.file("1.alidade", titled("first")),
                    broken = folder.file("2.alidade", "{\"format\": 7"),
                    last = folder.file("3.alidade", titled("last"));
  const ProgramRun run = alidadeCli({"fit", folder.path().string(), "--json"});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_THAT(run.err, StartsWith(broken + ": "));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  const std::vector<Json> lines = linesOf(run.out);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0]["session"], "first");
  EXPECT_EQ(lines[1]["file"], broken);
  EXPECT_THAT(run.err, HasSubstr(lines[1]["error"].get<std::string>()));
  EXPECT_FALSE(lines[1].contains("session"));
  EXPECT_EQ(lines[2]["session"], "last");
}

TEST(Batch, PrintsTextsForPeopleOneAfterTheOther) {
  const TemporaryFolder folder;
  const std::string one = folder.file("1", titled("one")), two = folder.file("2", titled("two"));
  const auto text = [](std::vector<std::string> files) {
    files.insert(files.begin(), {"fit", "--no-diagnosis"});
    return alidadeCli(files).out;
  };
  EXPECT_EQ(text({one, folder.path() / "missing", two}), text({one}) + "\n" + text({two}));
}

TEST(Batch, AnswersAFileNamedTwiceOnce) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.alidade", titled("a"));
  std::filesystem::create_symlink(file, folder.path() / "link.alidade");
  const ProgramRun run = alidadeCli({"fit", file, folder.path().string(), file, "--json"});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_EQ(linesOf(run.out).size(), 1u);
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 3) << run.err;
  EXPECT_THAT(run.err, HasSubstr("is named again"));
}

TEST(Batch, RefusesAFolderWithoutASession) {
  const TemporaryFolder folder;
  folder.file("notes.txt", "no session");
  folder.file(".hidden.alidade", titled("hidden"));
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"fit"}, {"diagnose", "--each"}, {"fit", paperSession}}) {
    std::vector<std::string> arguments = call;
    arguments.push_back(folder.path().string());
    const ProgramRun run = alidadeCli(arguments);
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("holds no session"));
    EXPECT_EQ(run.out.empty(), call.back() != paperSession);
  }
}

TEST(Batch, TellsHowFarItIsWhereAsked) {
  const ProgramRun run =
      alidadeCli({"fit", paperSession, "/no/such", "--json", "--no-diagnosis", "--progress"});
  EXPECT_THAT(run.err, HasSubstr("2 of 2 files done, 1 of them without a result\n"));
}

TEST(SessionFiles, OfAFolderAreInTheOrderOfTheirNames) {
  const TemporaryFolder folder;
  for (const char* name : {"b.alidade", "a.alidade", "c.txt"}) folder.file(name, "");
  std::filesystem::create_directory(folder.path() / "d.alidade");
  const std::string a = folder.path() / "a.alidade", b = folder.path() / "b.alidade";
  EXPECT_THAT(pathsOf(console::sessionFilesOf({folder.path().string()})), ElementsAre(a, b));
  const console::SessionFiles list = console::sessionFilesOf({b, folder.path().string() + "/"});
  EXPECT_THAT(pathsOf(list), ElementsAre(b, a));
  EXPECT_THAT(list.again, ElementsAre(b));
}

TEST(SessionFiles, ThatAreHardLinksAreTwo) {
  const TemporaryFolder folder;
  const std::string one = folder.file("1.alidade", ""), two = folder.path() / "2.alidade";
  std::filesystem::create_hard_link(one, two);
  EXPECT_THAT(pathsOf(console::sessionFilesOf({one, two})), ElementsAre(one, two));
}

TEST(OnOneLine, KeepsWhatADocumentSays) {
  const Json document = {{"a", {1, 2.5, nullptr}}, {"b, \n  c", "x:\n \"y\""}, {"empty", Json::object()}};
  const std::string line = console::onOneLine(document.dump(2) + "\n");
  EXPECT_EQ(Json::parse(line), document);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_THAT(line, StartsWith("{\"a\": [1, 2.5, null], "));
}

}  // namespace
}  // namespace alidade::test
