#include "app/console/commands/report_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "app/console/channels.h"
#include "app/console/commands/shared_options.h"
#include "app/console/other_program.h"
#include "core/answers/json_text.h"
#include "core/base/utf8.h"
#include "core/base/visible_text.h"

namespace alidade::console {

namespace {

namespace fs = std::filesystem;

std::string reportPath(const ReportRequest& request, const std::string& file) {
  const fs::path session(file),
      folder = request.into.empty() ? session.parent_path() : fs::path(request.into);
  return (folder / session.stem()).string() + ".pdf";
}

/// The path, preceded by "./" if it looks like an option.
std::string asArgument(const std::string& path) {
  return path.starts_with('-') ? "./" + path : path;
}

/// The message that `alidade` wrote to stderr, without the name of the file or the program before it.
std::string saidOf(std::string errors, const std::string& file) {
  while (errors.ends_with('\n')) errors.pop_back();
  for (const std::string& begin : {visibleText(file) + ": ", std::string("alidade: ")})
    if (errors.starts_with(begin)) return errors.substr(begin.size());
  return errors;
}

/// Gives a problem to each session whose report would replace another or has no name.
void refuseUnnamed(std::vector<ListedFile>& files, const ReportRequest& request) {
  std::map<std::string, std::string> sessions;  // by the path of the report
  for (ListedFile& file : files) {
    if (file.problem) continue;
    if (file.path == "-")
      file.problem = Problem{"a report is named like its session: name the file of the session"};
    else if (firstIllFormedByte(file.path))
      file.problem = Problem{"a name that is no UTF-8 cannot be opened here: rename the file"};
    else if (const auto [of, isNew] = sessions.try_emplace(reportPath(request, file.path), file.path); !isNew)
      file.problem = Problem{"its report would replace that of " + of->second + ", " + of->first +
                             ": rename one of the two, or write them into different folders"};
  }
}

Result<std::string> reportOf(const ReportRequest& request, const std::string& program,
                             const std::string& file) {
  const std::string out = reportPath(request, file), session = asArgument(file);
  std::vector<std::string> arguments{"--report", asArgument(out)};
  if (!request.language.empty()) arguments.insert(arguments.end(), {"--language", request.language});
  const SigningFiles& signing = request.signing;
  if (!signing.key.empty())
    arguments.insert(arguments.end(), {"--sign-key", asArgument(signing.key), "--sign-certificate",
                                       asArgument(signing.certificate)});
  if (!signing.passphraseFile.empty())
    arguments.insert(arguments.end(), {"--sign-passphrase-file", asArgument(signing.passphraseFile)});
  arguments.push_back(session);
  const Result<ProgramEnd> end = runToEnd(program, arguments);
  if (!end) return end.problem();
  const std::string said = saidOf(end->errors, session);
  if (end->exitCode != Done)
    return Problem{said.empty() ? "alidade ended with the exit code " + std::to_string(end->exitCode) : said};
  if (!said.empty()) notify(file, said);
  if (!request.batch.json) return "Report written to " + out + ".\n";
  return answerText({{"report", out}});
}

}  // namespace

void addReportCommand(CLI::App& app, ReportRequest& request) {
  CLI::App* report =
      app.add_subcommand("report", "The acceptance report of each session as PDF, named like the session.");
  report->add_option("FILE", request.files, "Sessions (*.alidade), or folders of them")->required();
  report->add_option("--into", request.into, "Existing folder for the reports; else each next to its session")
      ->check(CLI::ExistingDirectory);
  report->add_option("--language", request.language, "Language of the reports, such as en or zh_CN");
  addSigningOptions(*report, request.signing);
  addBatchOptions(*report, request.batch);
}

int giveReports(const ReportRequest& request) {
  const Result<std::string> program = installedProgram("alidade");
  if (!program) {
    notify("alidade-cli report", program.problem().text());
    return Failed;
  }
  SessionFiles list = sessionFilesOf(request.files);
  refuseUnnamed(list.files, request);
  BatchOptions batch = request.batch;
  batch.lines = true;
  return answerEach(
      list, [&](const std::string& file) { return reportOf(request, *program, file); }, batch);
}

}  // namespace alidade::console
