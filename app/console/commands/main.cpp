#include <CLI/CLI.hpp>
#include <csignal>
#include <memory>
#include <string>
#include <vector>

#include "app/console/channels.h"
#include "app/console/commands/certificate_command.h"
#include "app/console/commands/diagnose_command.h"
#include "app/console/commands/discover_command.h"
#include "app/console/commands/fit_command.h"
#include "app/console/commands/history_command.h"
#include "app/console/commands/import_command.h"
#include "app/console/commands/instrument_command.h"
#include "app/console/commands/instrument_simulator_command.h"
#include "app/console/commands/journal_command.h"
#include "app/console/commands/plan_command.h"
#include "app/console/commands/protocol_command.h"
#include "app/console/commands/report_command.h"
#include "app/console/commands/schema_command.h"
#include "app/console/commands/self_test_command.h"
#include "app/console/commands/simulate_command.h"
#include "app/console/commands/trial_command.h"
#include "app/console/session_files.h"
#include "core/base/failure.h"
#include "core/base/given_arguments.h"
#include "core/base/version.h"
#include "core/base/visible_text.h"

namespace {

using namespace alidade::console;

std::string callProblem(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> unknown = app.remaining();
  if (!app.get_subcommands().empty() || unknown.empty()) return error.what();
  return "there is no subcommand or option " + alidade::quotation(unknown.front());
}

int give(const alidade::Result<std::string>& answer, const std::string& subject) {
  return answer ? writeResult(*answer) : refuse(subject, answer.problem().text());
}

int giveImport(const ImportRequest& request, std::string& subject) {
  const auto options = importOptions(request);
  if (!options) return refuse(subject, options.problem().text());
  subject = request.files.size() == 1 ? inputName(request.files.front()) : "alidade-cli import";
  const alidade::Result<ImportAnswer> answer = runImport(request, *options);
  if (!answer) return refuse(subject, answer.problem().text());
  for (const std::string& remark : answer->remarks) notify(subject, remark);
  return writeResult(answer->result);
}

int giveJournal(const JournalRequest& request, std::string& subject) {
  subject = inputName(request.file);
  const alidade::Result<JournalAnswer> answer = runJournal(request);
  if (!answer) return refuse(subject, answer.problem().text());
  const int written = writeResult(answer->result);
  return answer->holds ? written : Failed;
}

int giveCertificate(const CertificateRequest& request, std::string& subject) {
  subject = inputName(request.file);
  const alidade::Result<CertificateAnswer> answer = runCertificate(request);
  if (!answer) return refuse(subject, answer.problem().text());
  for (const std::string& remark : answer->remarks) notify(subject, remark);
  return writeResult(answer->result);
}

int giveInstrument(const InstrumentRequest& request, std::string& subject) {
  subject = request.files.size() == 1 ? inputName(request.files.front()) : "alidade-cli instrument";
  const alidade::Result<InstrumentAnswer> answer = runInstrument(request);
  if (!answer) return refuse(subject, answer.problem().text());
  for (const std::string& remark : answer->remarks) notify(subject, remark);
  return writeResult(answer->result);
}

/// Writes the fit of one file, or of each file if several, a folder or a series are named.
int giveFits(const FitRequest& request, std::string& subject, VerdictExit& verdicts) {
  const auto answer = [&](const std::string& file) { return runFit(request, file, verdicts); };
  if (!namesMany(request.files) && !request.batch.jsonLines) {
    subject = inputName(request.files.front());
    return give(answer(request.files.front()), subject);
  }
  BatchOptions batch = request.batch;
  batch.table = !request.csv.empty();
  return answerEach(request.files, answer, batch);
}

int giveFit(const FitRequest& request, std::string& subject) {
  VerdictExit verdicts;
  const int code = giveFits(request, subject, verdicts);
  return code == Done && request.verdictExit ? verdicts.code() : code;
}

int giveDiagnosis(const DiagnoseRequest& request, std::string& subject) {
  if (request.each || request.batch.jsonLines)
    return answerEach(
        request.files, [&](const std::string& file) { return runDiagnose(request, file); }, request.batch);
  if (namesMany(request.files)) return giveSeries(request);
  subject = inputName(request.files.front());
  return give(runDiagnose(request, request.files.front()), subject);
}

/// Adds a command to the app. `add` lets its options fill in a request. Once the call is parsed, `give`
/// answers the request and returns the exit code.
template <typename Request, typename Add, typename Give>
void addCommand(CLI::App& app, int& exitCode, const Add& add, const Give& give) {
  const auto request = std::make_shared<Request>();
  add(app, *request);
  app.get_subcommands([](const CLI::App*) { return true; }).back()->callback([request, give, &exitCode] {
    exitCode = give(*request);
  });
}

/// Each command sets `subject` to the input that it processes.
void addCommands(CLI::App& app, int& exitCode, std::string& subject) {
  const auto ofNothing = [&](const auto& run) {
    return [&, run](const auto& request) { return give(run(request), subject); };
  };
  const auto ofFile = [&](const auto& run) {
    return [&, run](const auto& request) {
      subject = inputName(request.file);
      return give(run(request), subject);
    };
  };
  const auto heard = [&](const auto& giveThis) {
    return [&, giveThis](const auto& request) { return giveThis(request, subject); };
  };
  addCommand<FitRequest>(app, exitCode, addFitCommand, heard(giveFit));
  addCommand<DiagnoseRequest>(app, exitCode, addDiagnoseCommand, heard(giveDiagnosis));
  addCommand<DiscoverRequest>(app, exitCode, addDiscoverCommand, ofFile(runDiscover));
  addCommand<SimulateRequest>(app, exitCode, addSimulateCommand, ofNothing(runSimulate));
  addCommand<PlanRequest>(app, exitCode, addPlanCommand, ofFile(runPlan));
  addCommand<ProtocolRequest>(app, exitCode, addProtocolCommand, ofFile(runProtocol));
  addCommand<TrialRequest>(app, exitCode, addTrialCommand, ofNothing(runTrial));
  addCommand<JournalRequest>(app, exitCode, addJournalCommand, heard(giveJournal));
  addCommand<HistoryRequest>(app, exitCode, addHistoryCommand, giveHistory);
  addCommand<ImportRequest>(app, exitCode, addImportCommand, heard(giveImport));
  addCommand<InstrumentRequest>(app, exitCode, addInstrumentCommand, heard(giveInstrument));
  addCommand<SimulatorRequest>(app, exitCode, addSimulatorCommand, [&](const SimulatorRequest& request) {
    if (!request.session.empty()) subject = inputName(request.session);
    return give(runSimulator(request), subject);
  });
  addCommand<CertificateRequest>(app, exitCode, addCertificateCommand, heard(giveCertificate));
  addCommand<ReportRequest>(app, exitCode, addReportCommand, giveReports);
  addCommand<std::string>(app, exitCode, addSchemaCommand, ofNothing(runSchema));
  addCommand<SelfTestRequest>(app, exitCode, addSelfTestCommand, giveSelfTest);
}

/// Runs the call. Meanwhile `subject` names the input being processed.
int run(int argc, char** argv, std::string& subject) {
  if (const auto why = alidade::emptyArgument(argc, argv)) return refuse(subject, *why);
  CLI::App app("Intersection of rotatable arc guideways from theodolite readings.", "alidade-cli");
  app.set_version_flag("--version", "alidade-cli " + alidade::versionAndBuild());
  app.require_subcommand(1);
  int exitCode = Failed;
  addCommands(app, exitCode, subject);
  app.footer("Exit codes: 0 done, 2 bad input or call, 1 anything else; 3 and 4 with `fit --verdict-exit`.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return writeResult(app.help() + "\n");
  } catch (const CLI::CallForVersion& version) {
    return writeResult(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    return refuse("alidade-cli", callProblem(app, error) + ". `alidade-cli --help` lists what can be asked.");
  }
  return exitCode;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // exceeding the file size limit becomes an error message
  int exitCode = Failed;
  std::string subject = "alidade-cli";
  const auto failure = alidade::failureOf([&] { exitCode = run(argc, argv, subject); });
  if (failure) notify(subject, "the command failed: " + *failure);
  return exitCode;
}
