#include "ui/report/acceptance_report.h"

#include <QCryptographicHash>
#include <QPagedPaintDevice>
#include <QPainter>
#include <future>
#include <memory>

#include "core/base/atomic_file.h"
#include "core/base/version.h"
#include "core/session/session_file.h"
#include "core/statement/budget.h"
#include "ui/document/encoded_path.h"
#include "ui/language/languages.h"
#include "ui/report/attached_session.h"
#include "ui/report/device_history_report.h"
#include "ui/report/painted_pdf.h"
#include "ui/report/pdf_archive.h"
#include "ui/report/report_parts.h"
#include "ui/report/report_results.h"
#include "ui/report/report_sheet.h"
#include "ui/report/report_summary.h"
#include "ui/report/report_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

constexpr int longestTitle = 300;

QString sessionName(const Evaluation& evaluation, const ReportSource& source) {
  const QString title = QString::fromStdString(evaluation.session.title).trimmed();
  if (!title.isEmpty()) return title;
  return source.fileName.isEmpty() ? Report::tr("untitled session") : source.fileName;
}

QString fingerprint(const Evaluation& evaluation, const ReportSource& source) {
  if (source.saved && !source.sha256.isEmpty()) {
    return QStringLiteral("SHA-256 ") + QString::fromLatin1(source.sha256.toHex());
  }
  const QByteArray content = QByteArray::fromStdString(writeSession(evaluation.session));
  const QByteArray digest = QCryptographicHash::hash(content, QCryptographicHash::Sha256);
  return Report::tr("unsaved changes: SHA-256 of the session's content %1")
      .arg(QString::fromLatin1(digest.toHex()));
}

/// The program that wrote the report, and the report's number if it has one.
QString productLine(const Session& session) {
  const QString version = qText(versionAndBuild());
  const QString number = QString::fromStdString(session.report.number).trimmed();
  return number.isEmpty() ? Report::tr("Alidade %1 · Acceptance report").arg(version)
                          : Report::tr("Alidade %1 · Acceptance report · No. %2").arg(version, number);
}

ReportFrame frameFor(const Evaluation& evaluation, const ReportSource& source, const ReportOptions& options) {
  return {.product = productLine(evaluation.session),
          .session = sessionName(evaluation, source),
          .fileName = source.fileName.isEmpty() ? Report::tr("session not saved to a file") : source.fileName,
          .fingerprint = fingerprint(evaluation, source),
          .date = options.date.toString(QStringLiteral("yyyy-MM-dd HH:mm"))};
}

void layOut(ReportSheet& sheet, const Gap& gap, const ReportOptions& options) {
  const Evaluation& evaluation = *gap.evaluation;
  const auto prints = [&](ReportPart part) { return isPrinted(part, options.contents, gap); };
  FrontPage front = addSummary(sheet, gap, options);
  addPlots(sheet, gap, prints(ReportPart::Arcs), prints(ReportPart::Residuals));
  prints(ReportPart::Readings) ? addReadings(sheet, evaluation) : addRemarkableReadings(sheet, evaluation);
  if (prints(ReportPart::Journal)) addJournal(sheet, evaluation);
  if (!front.hasMethod) front.hasMethod = addMethodInTheRest(sheet, evaluation);
  if (prints(ReportPart::Budget)) {
    addUncertainty(sheet, gap);
    if (options.simulated && options.simulated->intersection)
      addStatement(sheet, monteCarloCheck(*options.simulated, &*evaluation.fit.intersection));
  }
  addKnown(sheet, gap);
  if (prints(ReportPart::Gap)) {
    addGap(sheet, gap);
    addForms(sheet, gap);
  }
  if (prints(ReportPart::Closures)) addClosures(sheet, gap);
  if (prints(ReportPart::Undetectable)) addUndetectable(sheet, gap);
  if (options.history) {
    sheet.newPage();
    addDeviceHistory(sheet, *options.history);
  }
  if (!front.hasMethod) addMethod(sheet, evaluation);
  if (!front.isSigned) addSignatures(sheet, evaluation.session);
  sheet.balance();
}

/// The author is the responsible party: the laboratory, or else the operator.
PdfInformation informationOf(const Evaluation& evaluation, const ReportSource& source,
                             const ReportOptions& options) {
  const auto typed = [](const std::string& text) { return shortLine(qText(text).trimmed(), longestTitle); };
  const QString laboratory = typed(evaluation.session.report.laboratory);
  return {.title = reportTitle(evaluation, source),
          .author = laboratory.isEmpty() ? typed(evaluation.session.operatorName) : laboratory,
          .creator = qText("Alidade " + versionAndBuild()),
          .date = options.date};
}

/// The name of the session as alidade-cli derives it from the file.
std::string nameInResults(const Session& session, const ReportSource& source) {
  return session.title.empty() ? source.fileName.toStdString() : session.title;
}

/// Computes the results on another thread, since many readings take long. Absent if nothing is attached.
std::future<std::optional<std::string>> resultsInBackground(const ReportOptions& options,
                                                            const ReportSource& source) {
  return std::async(std::launch::async, [gap = options.gap, isWanted = options.hasSession, source] {
    const Session& session = gap->evaluation->session;
    return isWanted ? resultsJson(*gap, nameInResults(session, source), source.bytesOf(session))
                    : std::nullopt;
  });
}

std::vector<PdfAttachment> attachmentsOf(const ReportSource& source, const ReportOptions& options,
                                         std::optional<std::string> results) {
  std::vector<PdfAttachment> attachments;
  if (!options.hasSession) return attachments;
  const Session& session = options.gap->evaluation->session;
  attachments.push_back({.fileName = attachedName(source.fileName),
                         .description = Report::tr("The session of this report, to be opened with Alidade"),
                         .bytes = source.bytesOf(session),
                         .relationship = "/Source"});
  if (results)
    attachments.push_back({.fileName = QStringLiteral("results.json"),
                           .description = Report::tr("The results of this report, to be read by programs"),
                           .bytes = *std::move(results),
                           .relationship = "/Data"});
  return attachments;
}

/// Runs `work` in the report's language. `goesOn` runs in the window's language, since it processes window
/// events.
template <typename Work>
auto inLanguageOf(const ReportOptions& options, Work work) {
  const QString before = shownLanguage();
  const LanguageScope language(options.language);
  ReportOptions within = options;
  if (options.goesOn)
    within.goesOn = [&options, &before](double done) {
      const LanguageScope ofTheWindow(before);
      return options.goesOn(done);
    };
  return work(within);
}

/// Options with the gap, which is assessed if absent.
ReportOptions withGap(ReportOptions options, const Evaluation& evaluation) {
  if (!options.gap)
    options.gap = std::make_shared<const Gap>(
        withDependences(assessGap(std::make_shared<const Evaluation>(evaluation))));
  return options;
}

bool paintPages(QPagedPaintDevice& device, const Evaluation& evaluation, const ReportSource& source,
                const ReportOptions& options) {
  return paintSheets(device, frameFor(evaluation, source, options), options.paper.margins,
                     [&](ReportSheet& sheet) {
                       sheet.setWatch(options.goesOn);
                       layOut(sheet, *options.gap, options);
                     });
}

/// `name`: name of the output, for the text of a problem.
Result<std::string> pdfOf(const Evaluation& evaluation, const ReportSource& source, const QString& name,
                          const ReportOptions& options) {
  auto results = resultsInBackground(options, source);
  const auto painted = paintedPdf(options.paper, [&](QPagedPaintDevice& device) {
    return paintPages(device, evaluation, source, options);
  });
  if (!painted) return Problem{Report::tr("%1 cannot be written: painting failed").arg(name).toStdString()};
  return archivedPdf(*painted, informationOf(evaluation, source, options),
                     attachmentsOf(source, options, results.get()));
}

}  // namespace

std::string ReportSource::bytesOf(const Session& session) const {
  return saved && !bytes.isEmpty() ? bytes.toStdString() : writeSession(session);
}

std::optional<Problem> writeSigned(const QString& path, const std::string& bytes,
                                   const std::optional<Signer>& signer, const ReportSource& source) {
  std::vector<std::string> inputs = encodedPaths(source.paths);
  const std::string out = encodedPath(path);
  if (!signer) return writeFile(out, bytes, inputs);
  const Result<std::string> signature = signer->sign(bytes);
  if (!signature) return signature.problem();
  inputs.insert(inputs.end(), signer->paths().begin(), signer->paths().end());
  return writeFiles({{out, bytes}, {signaturePath(out), *signature}}, inputs);
}

QString reportTitle(const Evaluation& evaluation, const ReportSource& source) {
  return Report::tr("Acceptance report: %1").arg(shortLine(sessionName(evaluation, source), longestTitle));
}

bool paintAcceptanceReport(QPagedPaintDevice& device, const Evaluation& evaluation,
                           const ReportSource& source, const ReportOptions& options) {
  return inLanguageOf(options, [&](const ReportOptions& within) {
    return paintPages(device, evaluation, source, withGap(within, evaluation));
  });
}

Result<QString> writeAcceptanceReport(const Evaluation& evaluation, const ReportSource& source,
                                      const QString& outPath, const ReportOptions& options) {
  return inLanguageOf(options, [&](const ReportOptions& within) {
    const ReportOptions whole = withGap(within, evaluation);
    const Result<std::string> pdf = pdfOf(evaluation, source, outPath, whole);
    if (!pdf) return Result<QString>(pdf.problem());
    if (auto problem = writeSigned(outPath, *pdf, whole.signer, source))
      return Result<QString>(*std::move(problem));
    return Result<QString>(outPath);
  });
}

Result<std::string> acceptanceReportPdf(const Evaluation& evaluation, const ReportSource& source,
                                        const ReportOptions& options) {
  return inLanguageOf(options, [&](const ReportOptions& within) {
    return pdfOf(evaluation, source, source.fileName, withGap(within, evaluation));
  });
}

}  // namespace alidade::ui
