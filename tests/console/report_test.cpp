#include <gmock/gmock.h>

#include <filesystem>

#include "tests/console/console.h"
#include "tests/support/file_content.h"

// `alidade-cli report`: a PDF for each session, painted by `alidade`.

namespace alidade::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::string sessionIn(const TemporaryFolder& folder, const std::string& name) {
  const fs::path path = folder.path() / name;
  fs::create_directories(path.parent_path());
  fs::copy_file(paperSession, path);
  return path;
}

std::string pdfOf(std::string session) {
  return session.replace(session.rfind('.'), std::string::npos, ".pdf");
}

ProgramRun report(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "report");
  return alidadeCli(arguments);
}

TEST(ReportCall, WritesOneBesideItsSession) {
  const TemporaryFolder folder;
  const std::string session = sessionIn(folder, "a b.alidade"), pdf = pdfOf(session);
  const ProgramRun run = report({session});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.out, "Report written to " + pdf + ".\n");
  EXPECT_THAT(run.err, StartsWith(session + ": The report says “not stated” for: "));
  EXPECT_THAT(contentOf(pdf), StartsWith("%PDF-"));
}

TEST(ReportCall, WritesThoseOfAFolderIntoAnother) {
  const TemporaryFolder folder, into;
  sessionIn(folder, "1.alidade");
  sessionIn(folder, "2.alidade");
  sessionIn(folder, "-3.alidade");
  const std::string where = into.path();
  const ProgramRun run = runProgram({.program = ALIDADE_CLI,
                                     .arguments = {"report", ".", "--into", where, "--language", "zh_CN"},
                                     .directory = folder.path()});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.out, "Report written to " + where + "/-3.pdf.\nReport written to " + where +
                         "/1.pdf.\nReport written to " + where + "/2.pdf.\n");
  for (const char* name : {"/-3.pdf", "/1.pdf", "/2.pdf"})
    EXPECT_THAT(contentOf(where + name), StartsWith("%PDF-"));
  EXPECT_FALSE(fs::exists(folder.path() / "1.pdf"));
}

TEST(ReportCall, NamesTheUnusableAndWritesTheOthers) {
  const TemporaryFolder folder;
  const std::string good = sessionIn(folder, "good.alidade"), bad = folder.file("bad.alidade", "{"),
                    missing = folder.path() / "missing.alidade";
  const ProgramRun run = report({bad, missing, good, "-", "--json"});
  EXPECT_EQ(run.exitCode, 2);
  std::istringstream lines(run.out);
  std::vector<nlohmann::json> answers;
  for (std::string line; std::getline(lines, line);) answers.push_back(nlohmann::json::parse(line));
  ASSERT_EQ(answers.size(), 4u);
  EXPECT_EQ(answers[0]["file"], bad);
  EXPECT_THAT(answers[0]["error"].get<std::string>(), HasSubstr("ends too early"));
  EXPECT_THAT(answers[1]["error"].get<std::string>(), HasSubstr("cannot be opened"));
  EXPECT_EQ(answers[2]["report"], pdfOf(good));
  EXPECT_EQ(answers[2]["program"]["name"], "Alidade");
  EXPECT_THAT(answers[3]["error"].get<std::string>(), HasSubstr("name the file of the session"));
  EXPECT_FALSE(fs::exists(pdfOf(bad)));
}

TEST(ReportCall, ReplacesNoOtherReportOfTheCall) {
  const TemporaryFolder folder, into;
  const std::string first = sessionIn(folder, "a/s.alidade"), second = sessionIn(folder, "b/s.alidade");
  const ProgramRun run = report({first, second, first, "--into", into.path().string()});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_THAT(run.err, HasSubstr(second + ": its report would replace that of " + first));
  EXPECT_THAT(run.err, HasSubstr(first + ": is named again"));
  EXPECT_EQ(run.out, "Report written to " + into.path().string() + "/s.pdf.\n");
  EXPECT_EQ(report({first, second}).exitCode, 0);
}

TEST(ReportCall, NeverReplacesWhatItRead) {
  const TemporaryFolder folder;
  const std::string session = sessionIn(folder, "s.alidade"), pdf = pdfOf(session);
  ASSERT_EQ(report({session}).exitCode, 0);
  const std::string before = contentOf(pdf);
  const ProgramRun run = report({pdf});  // the PDF embeds its session
  expectRefusal(run);
  EXPECT_THAT(run.err, StartsWith(pdf + ": "));
  EXPECT_EQ(contentOf(pdf), before);
}

TEST(ReportCall, RefusesABadCall) {
  const TemporaryFolder folder;
  const std::string session = sessionIn(folder, "s.alidade");
  const ProgramRun nowhere = report({session, "--into", folder.path().string() + "/none"});
  expectRefusal(nowhere);
  EXPECT_THAT(nowhere.err, HasSubstr("--into"));
  const ProgramRun foreign = report({session, "--language", "xx"});
  expectRefusal(foreign);
  EXPECT_THAT(foreign.err, StartsWith(session + ": --language"));
  expectRefusal(report({session, "--sign-key", "k.pem"}));
}

TEST(ReportCall, SaysWhichProgramItLacks) {
  const TemporaryFolder folder;
  const std::string alone = folder.path() / "alidade-cli", session = sessionIn(folder, "s.alidade");
  fs::copy_file(ALIDADE_CLI, alone);
  const ProgramRun run = runProgram({.program = alone, .arguments = {"report", session}});
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err, HasSubstr("needs the program alidade in the folder of alidade-cli"));
  EXPECT_THAT(alidadeCli({"--help"}).out, HasSubstr("report"));
}

}  // namespace
}  // namespace alidade::test
