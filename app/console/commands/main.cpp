#include <CLI/CLI.hpp>
#include <csignal>
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
#include "app/console/commands/schema_command.h"
#include "app/console/commands/self_test_command.h"
#include "app/console/commands/simulate_command.h"
#include "app/console/commands/trial_command.h"
#include "app/console/session_files.h"
#include "core/base/failure.h"
#include "core/base/freed_memory.h"
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

/// One file gets one result, several files or a folder one result each.
int giveFit(const FitRequest& request, std::string& subject) {
  if (namesMany(request.files))
    return answerEach(
        request.files, [&](const std::string& file) { return runFit(request, file); }, request.batch);
  subject = inputName(request.files.front());
  return give(runFit(request, request.files.front()), subject);
}

int giveDiagnosis(const DiagnoseRequest& request, std::string& subject) {
  if (request.each)
    return answerEach(
        request.files, [&](const std::string& file) { return runDiagnose(request, file); }, request.batch);
  if (namesMany(request.files)) return giveSeries(request);
  subject = inputName(request.files.front());
  return give(runDiagnose(request, request.files.front()), subject);
}

/// Sets `subject` to the input while that is processed.
int run(int argc, char** argv, std::string& subject) {
  if (const auto why = alidade::emptyArgument(argc, argv)) return refuse(subject, *why);
  CLI::App app("Intersection of rotatable arc guideways from theodolite readings.", "alidade-cli");
  app.set_version_flag("--version", "alidade-cli " + alidade::versionAndBuild());
  app.require_subcommand(1);
  FitRequest fitRequest;
  addFitCommand(app, fitRequest);
  DiagnoseRequest diagnoseRequest;
  addDiagnoseCommand(app, diagnoseRequest);
  DiscoverRequest discoverRequest;
  addDiscoverCommand(app, discoverRequest);
  SimulateRequest simulateRequest;
  addSimulateCommand(app, simulateRequest);
  PlanRequest planRequest;
  addPlanCommand(app, planRequest);
  ProtocolRequest protocolRequest;
  addProtocolCommand(app, protocolRequest);
  TrialRequest trialRequest;
  addTrialCommand(app, trialRequest);
  JournalRequest journalRequest;
  addJournalCommand(app, journalRequest);
  HistoryRequest historyRequest;
  addHistoryCommand(app, historyRequest);
  ImportRequest importRequest;
  addImportCommand(app, importRequest);
  InstrumentRequest instrumentRequest;
  addInstrumentCommand(app, instrumentRequest);
  SimulatorRequest simulatorRequest;
  addSimulatorCommand(app, simulatorRequest);
  CertificateRequest certificateRequest;
  addCertificateCommand(app, certificateRequest);
  std::string schema;
  addSchemaCommand(app, schema);
  SelfTestRequest selfTestRequest;
  addSelfTestCommand(app, selfTestRequest);
  app.footer("Exit codes: 0 done, 2 bad input or call, 1 anything else.");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return writeResult(app.help() + "\n");
  } catch (const CLI::CallForVersion& version) {
    return writeResult(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    return refuse("alidade-cli", callProblem(app, error) + ". `alidade-cli --help` lists what can be asked.");
  }

  if (app.got_subcommand("self-test")) return giveSelfTest(selfTestRequest);
  if (app.got_subcommand("simulate")) return give(runSimulate(simulateRequest), subject);
  if (app.got_subcommand("trial")) return give(runTrial(trialRequest), subject);
  if (app.got_subcommand("history")) return giveHistory(historyRequest);
  if (app.got_subcommand("import")) return giveImport(importRequest, subject);
  if (app.got_subcommand("instrument")) return giveInstrument(instrumentRequest, subject);
  if (app.got_subcommand("instrument-simulator")) {
    if (!simulatorRequest.session.empty()) subject = inputName(simulatorRequest.session);
    return give(runSimulator(simulatorRequest), subject);
  }
  if (app.got_subcommand("schema")) return give(runSchema(schema), subject);
  if (app.got_subcommand("certificate")) return giveCertificate(certificateRequest, subject);
  const auto giveFrom = [&](const auto& request, const auto& runCommand) {
    subject = inputName(request.file);
    return give(runCommand(request), subject);
  };
  if (app.got_subcommand("plan")) return giveFrom(planRequest, runPlan);
  if (app.got_subcommand("protocol")) return giveFrom(protocolRequest, runProtocol);
  if (app.got_subcommand("discover")) return giveFrom(discoverRequest, runDiscover);
  if (app.got_subcommand("journal")) return giveJournal(journalRequest, subject);
  if (app.got_subcommand("diagnose")) return giveDiagnosis(diagnoseRequest, subject);
  return giveFit(fitRequest, subject);
}

}  // namespace

int main(int argc, char** argv) {
  alidade::keepFreedMemory();
  std::signal(SIGXFSZ, SIG_IGN);  // exceeding the file size limit becomes an error message
  int exitCode = Failed;
  std::string subject = "alidade-cli";
  const auto failure = alidade::failureOf([&] { exitCode = run(argc, argv, subject); });
  if (failure) notify(subject, "the command failed: " + *failure);
  return exitCode;
}
