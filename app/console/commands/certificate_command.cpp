#include "app/console/commands/certificate_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/console/commands/shared_options.h"
#include "app/console/session_input.h"
#include "core/answers/fit_answer.h"
#include "core/base/atomic_file.h"
#include "core/base/file_bytes.h"
#include "core/base/file_target.h"
#include "core/base/list_text.h"
#include "core/base/version.h"
#include "core/base/visible_text.h"
#include "core/certificate/calibration_certificate.h"
#include "core/session/session_file.h"

namespace alidade::console {

namespace {

std::string fileNameOf(const std::string& path) {
  return wellFormed(std::filesystem::path(path).filename().string());
}

struct ReadSession {
  std::string bytes;
  Session session;
};

/// The session and the bytes to embed: those of the file or, if a record is added, of the changed session.
Result<ReadSession> readWhole(const CertificateRequest& request) {
  Result<std::string> bytes = request.file == "-" ? readStandardInput() : readFile(request.file);
  if (!bytes) return bytes.problem();
  Result<Session> session = readSession(*bytes);
  if (!session) return session.problem();
  ReadSession read{*std::move(bytes), *std::move(session)};
  if (!request.instrument.empty()) {
    if (auto problem = addRecord(read.session, request.instrument)) return *std::move(problem);
    read.bytes = writeSession(read.session);
  }
  return read;
}

Result<std::string> readReport(const std::string& path) {
  Result<std::string> bytes = readFile(path);
  if (!bytes) return Problem{"--pdf " + visibleText(path) + ": " + bytes.problem().text()};
  if (!bytes->starts_with("%PDF-"))
    return Problem{"--pdf " + visibleText(path) + " is no PDF: give one that `alidade --report` wrote"};
  return bytes;
}

std::optional<Problem> writeAll(const CertificateRequest& request, const std::string& xml,
                                const std::optional<Signer>& signer) {
  if (request.out == "-") return Problem{"--out - names no file: give a path to write to"};
  std::vector<std::string> inputs{request.file};
  for (const std::string* input : {&request.pdf, &request.instrument})
    if (!input->empty()) inputs.push_back(*input);
  if (signer) inputs.insert(inputs.end(), signer->paths().begin(), signer->paths().end());
  std::vector<FileContent> contents{{request.out, xml}};
  std::string signature;
  if (signer) {
    Result<std::string> made = signer->sign(xml);
    if (!made) return made.problem();
    signature = *std::move(made);
    contents.push_back({signaturePath(request.out), signature});
  }
  return writeFiles(contents, inputs);
}

}  // namespace

void addCertificateCommand(CLI::App& app, CertificateRequest& request) {
  CLI::App* command = app.add_subcommand(
      "certificate", "The digital calibration certificate of a session (PTB DCC 3.2.0), for other systems.");
  command->add_option("FILE", request.file, "Session (*.alidade); - reads standard input")->required();
  command->add_option("--out", request.out, "The certificate's file (*.xml)")->required();
  command->add_option("--pdf", request.pdf, "The acceptance report that goes with it, embedded");
  command->add_option("--measured-on", request.measuredOn,
                      "Day of the measurement where the session states none");
  command->add_option("--country", request.country,
                      "Of the laboratory, its two letters after ISO 3166-1: DE");
  command->add_option("--performed-at", request.performedAt, "Where it was measured")
      ->check(CLI::IsMember({"laboratory", "customer", "laboratoryBranch", "customerBranch", "other"}));
  command->add_option("--manufacturer", request.manufacturer, "Maker of the device");
  command->add_option("--issued", request.issued, "Day of issue; none is stated if not given");
  command->add_flag("--draft", request.isDraft,
                    "Make it in spite of missing entries, which are “not stated” in it");
  command->add_option("--instrument", request.instrument,
                      "Take what this instrument record says (*.alidade-instrument), for this run");
  addSigningOptions(*command, request.signing);
}

Result<CertificateAnswer> runCertificate(const CertificateRequest& request) {
  const Result<std::optional<Signer>> signer = signerOf(request.signing);
  if (!signer) return signer.problem();
  Result<ReadSession> read = readWhole(request);
  if (!read) return read.problem();
  const Session& session = read->session;
  const Gap gap = assessGap(std::make_shared<const Evaluation>(evaluate(session)));
  const std::string name = nameOf(session, request.file);
  const Result<FitAnswer> answer = fitAnswerOf(gap, name, read->bytes);
  if (!answer) return answer.problem();

  CertificateOptions options{.version = versionAndBuild(),
                             .measuredOn = request.measuredOn,
                             .country = request.country,
                             .performedAt = request.performedAt,
                             .manufacturer = request.manufacturer,
                             .issued = request.issued,
                             .isDraft = request.isDraft};
  std::string report;
  if (!request.pdf.empty()) {
    Result<std::string> bytes = readReport(request.pdf);
    if (!bytes) return bytes.problem();
    report = *std::move(bytes);
    options.report = CertificateDocument{fileNameOf(request.pdf), "application/pdf", report};
  }
  const Result<CalibrationCertificate> certificate = calibrationCertificate(
      {session, *answer, request.file == "-" ? std::string() : fileNameOf(request.file), read->bytes},
      options);
  if (!certificate) {
    Problem problem = certificate.problem();
    if (problem.where.field == "measured_on") problem.what += ", or give --measured-on";
    if (problem.where.field.empty())
      problem.what +=
          ". Country and place are --country and --performed-at, the session states the rest; "
          "--draft makes one without";
    return problem;
  }
  if (auto problem = writeAll(request, certificate->xml, *signer)) return *std::move(problem);

  CertificateAnswer done;
  done.result = "Certificate written to " + request.out + ".\n";
  if (*signer) done.result += "Signature written to " + signaturePath(request.out) + ".\n";
  if (!certificate->notStated.empty())
    done.remarks.push_back("A draft: the certificate says “not stated” for " +
                           listed({certificate->notStated.begin(), certificate->notStated.end()}) + ".");
  return done;
}

}  // namespace alidade::console
