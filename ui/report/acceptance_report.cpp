#include "ui/report/acceptance_report.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <memory>

#include "core/base/atomic_file.h"
#include "core/session/session_file.h"
#include "ui/report/report_gap.h"
#include "ui/report/report_journal.h"
#include "ui/report/report_plots.h"
#include "ui/report/report_readings.h"
#include "ui/report/report_result.h"
#include "ui/report/report_sheet.h"
#include "ui/report/report_summary.h"
#include "ui/text/encoded_path.h"
#include "ui/text/simulation_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

constexpr int longestTitle = 300;

QString sessionName(const Evaluation& evaluation, const ReportSource& source) {
  const QString title = QString::fromStdString(evaluation.session.title).trimmed();
  if (!title.isEmpty()) return title;
  return source.fileName.isEmpty() ? QStringLiteral("untitled session") : source.fileName;
}

QString fingerprint(const Evaluation& evaluation, const ReportSource& source) {
  if (source.saved && !source.sha256.isEmpty()) {
    return QStringLiteral("SHA-256 ") + QString::fromLatin1(source.sha256.toHex());
  }
  const QByteArray content = QByteArray::fromStdString(writeSession(evaluation.session));
  const QByteArray digest = QCryptographicHash::hash(content, QCryptographicHash::Sha256);
  return QStringLiteral("unsaved changes: SHA-256 of the session's content ") +
         QString::fromLatin1(digest.toHex());
}

ReportFrame frameFor(const Evaluation& evaluation, const ReportSource& source, const ReportOptions& options) {
  const QString number = QString::fromStdString(evaluation.session.report.number).trimmed();
  return {
      .product = QStringLiteral("Alidade " ALIDADE_VERSION " · Acceptance report") +
                 (number.isEmpty() ? number : QStringLiteral(" · No. ") + number),
      .session = sessionName(evaluation, source),
      .fileName = source.fileName.isEmpty() ? QStringLiteral("session not saved to a file") : source.fileName,
      .fingerprint = fingerprint(evaluation, source),
      .date = options.date.toString(QStringLiteral("yyyy-MM-dd HH:mm"))};
}

bool paintReport(QBuffer& buffer, const Evaluation& evaluation, const ReportSource& source,
                 const ReportOptions& options) {
  QPdfWriter writer(&buffer);
  writer.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
  writer.setResolution(1200);
  writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)));
  writer.setTitle(QStringLiteral("Acceptance report: ") +
                  shortLine(sessionName(evaluation, source), longestTitle));
  writer.setCreator(QStringLiteral("Alidade " ALIDADE_VERSION));
  ReportSheet sheet(writer, frameFor(evaluation, source, options));
  sheet.setWatch(options.goesOn);
  const Gap gap = options.gap ? *options.gap : assessGap(std::make_shared<const Evaluation>(evaluation));
  FrontPage front = addSummary(sheet, gap, options);
  addPlots(sheet, evaluation);
  addReadings(sheet, evaluation);
  addJournal(sheet, evaluation);
  if (!front.hasMethod) front.hasMethod = addMethodInTheRest(sheet, evaluation);
  addUncertainty(sheet, gap);
  if (options.simulated && options.simulated->intersection)
    sheet.paragraph(simulationParagraph(*options.simulated));
  addGap(sheet, gap);
  addClosures(sheet, gap);
  addUnseen(sheet, gap);
  if (!front.hasMethod) addMethod(sheet, evaluation);
  if (!front.isSigned) addSignatures(sheet, evaluation.session);
  QPainter painter;
  if (!painter.begin(&writer)) return false;
  const bool isWhole = sheet.paint(painter);
  return painter.end() && isWhole;
}

}  // namespace

Result<QString> writeAcceptanceReport(const Evaluation& evaluation, const ReportSource& source,
                                      const QString& outPath, const ReportOptions& options) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  if (!paintReport(buffer, evaluation, source, options))
    return Problem{QStringLiteral("%1 cannot be written: painting failed").arg(outPath).toStdString()};
  const QByteArray& pdf = buffer.data();
  const std::string_view bytes(pdf.constData(), static_cast<std::size_t>(pdf.size()));
  std::vector<std::string> inputs;
  for (const QString& path : source.paths) inputs.push_back(encodedPath(path));
  if (auto problem = writeFile(encodedPath(outPath), bytes, inputs)) return *std::move(problem);
  return outPath;
}

}  // namespace alidade::ui
