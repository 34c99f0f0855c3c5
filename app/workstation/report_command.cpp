#include "app/workstation/report_command.h"

#include <QTextStream>

#include "core/base/failure.h"
#include "ui/dialogs/report_source.h"
#include "ui/document/session_document.h"
#include "ui/jobs/evaluation.h"
#include "ui/report/empty_fields.h"
#include "ui/text/visible_text.h"

namespace alidade {

namespace {

int refuse(const QString& path, const Problem& problem) {
  QTextStream(stderr) << ui::visibleLine(path) << ": " << ui::visibleLine(problem.text()) << '\n';
  return 2;
}

int write(const QString& path, const QString& reportPath) {
  ui::SessionDocument document;
  if (const auto problem = document.load(path)) return refuse(path, *problem);
  const ui::Evaluation evaluation = ui::evaluate(document.session());
  if (!evaluation.examined.problems.empty()) return refuse(path, evaluation.examined.problems.front());
  const auto written = ui::writeAcceptanceReport(evaluation, ui::reportSource(document), reportPath);
  if (!written) return refuse(path, written.problem());
  if (const QStringList empty = ui::emptyReportFields(document.session()); !empty.isEmpty())
    QTextStream(stderr) << ui::visibleLine(path) << ": The report leaves out what the session leaves empty: "
                        << empty.join(QStringLiteral(", ")) << ".\n";
  return 0;
}

}  // namespace

int writeReport(const QString& path, const QString& reportPath) {
  int exitCode = 1;
  const auto failure = failureOf([&] { exitCode = write(path, reportPath); });
  if (failure)
    QTextStream(stderr) << ui::visibleLine(path) << ": The report failed: " << ui::visibleLine(*failure)
                        << ".\n";
  return exitCode;
}

}  // namespace alidade
