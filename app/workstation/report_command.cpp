#include "app/workstation/report_command.h"

#include <QTextStream>
#include <memory>
#include <string>
#include <vector>

#include "core/base/failure.h"
#include "core/base/list_text.h"
#include "core/base/phrase.h"
#include "core/evaluation/evaluation.h"
#include "core/session/hindrance.h"
#include "ui/dialogs/report_flow.h"
#include "ui/document/session_document.h"
#include "ui/report/empty_fields.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade {

namespace {

int refuse(const QString& path, const Problem& problem) {
  QTextStream(stderr) << ui::visibleLine(path) << ": " << ui::visibleLine(problem.text()) << '\n';
  return 2;
}

/// The date in SOURCE_DATE_EPOCH, which reproducible builds set to get identical bytes; without it, now.
QDateTime dateOfReport() {
  bool isSet = false;
  const qint64 seconds = qEnvironmentVariable("SOURCE_DATE_EPOCH").toLongLong(&isSet);
  return isSet ? QDateTime::fromSecsSinceEpoch(seconds, Qt::UTC) : QDateTime::currentDateTime();
}

/// If entries are missing, writes `sentence` (for `Phrase::of`) with their names to stderr. Returns 0.
int reportLacks(const QString& path, const char* sentence, const QStringList& lacks) {
  std::vector<std::string> nouns;
  for (const QString& noun : lacks) nouns.push_back(noun.toStdString());
  if (!lacks.isEmpty())
    QTextStream(stderr) << ui::visibleLine(path) << ": " << ui::qText(Phrase::of(sentence, listed(nouns)))
                        << '\n';
  return 0;
}

int write(const ReportCommand& command) {
  const QString& path = command.path;
  ui::ReportOptions options;
  options.date = dateOfReport();
  if (!command.signing.key.empty()) {
    const Result<Signer> signer = Signer::load(command.signing);
    if (!signer) return refuse(path, signer.problem());
    options.signer = *signer;
  }
  ui::SessionDocument document;
  if (const auto problem = document.load(path)) return refuse(path, *problem);
  const Evaluation evaluation = evaluate(document.session());
  if (const auto problems = hindrances(evaluation.session, evaluation.examined.problems); !problems.empty())
    return refuse(path, problems.front());
  const ui::ReportSource source = ui::reportSource(document);
  if (command.certificate.isEmpty()) {
    const auto written = ui::writeAcceptanceReport(evaluation, source, command.report, options);
    if (!written) return refuse(path, written.problem());
    return reportLacks(path, PHRASE_LATER("Phrase", "The report says “not stated” for: %1."),
                       ui::emptyReportFields(document.session()));
  }
  options.gap =
      std::make_shared<const Gap>(withDependences(assessGap(std::make_shared<const Evaluation>(evaluation))));
  const auto written = ui::writeCertificate(source, command.certificate, options, command.entries);
  if (!written) return refuse(path, written.problem());
  return reportLacks(
      path, PHRASE_LATER("Phrase", "A draft: the certificate says “not stated” for what is missing: %1."),
      *written);
}

}  // namespace

int writeReport(const ReportCommand& command) {
  int exitCode = 1;
  const auto failure = failureOf([&] { exitCode = write(command); });
  if (failure)
    QTextStream(stderr) << ui::visibleLine(command.path)
                        << ": The report failed: " << ui::visibleLine(*failure) << ".\n";
  return exitCode;
}

}  // namespace alidade
