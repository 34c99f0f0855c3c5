#include "ui/report/device_history_report.h"

#include <QPagedPaintDevice>

#include "core/base/atomic_file.h"
#include "core/base/version.h"
#include "core/series/history/history_json.h"
#include "core/series/history/history_sentences.h"
#include "core/series/history/history_statement.h"
#include "ui/charts/history/history_plot.h"
#include "ui/document/encoded_path.h"
#include "ui/report/painted_pdf.h"
#include "ui/report/pdf_archive.h"
#include "ui/report/report_parts.h"
#include "ui/report/report_sheet.h"
#include "ui/report/report_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

void addHistoryChart(ReportSheet& sheet, const QuantityHistory& quantity) {
  constexpr double height = 92;  // mm
  sheet.keepTogether(height + 12);
  const auto plot = std::make_shared<HistoryPlot>();
  plot->setHistory(quantity.history, qText(quantityName(quantity.id)), quantity.unit);
  addPlot(sheet, plot, height);
  sheet.paragraph(Report::tr("Control chart. Bars: ± U, as in the table. Broken lines: centre line ± three "
                             "standard uncertainties of each value, without the part common to all values; "
                             "dotted: ± three times the scatter from the moving range. EWMA: exponentially "
                             "weighted average with λ = 0.2 and its exact limits."),
                  type::small);
}

void layOut(ReportSheet& sheet, const DeviceHistory& device) {
  sheet.text(Report::tr("Device history"), type::title, 0, sheet.y(), ReportSheet::width);
  sheet.skip(sheet.lineHeight(type::title) + 0.5);
  sheet.paragraph(shortLine(qText(deviceName(device)), 300), type::subtitle);
  sheet.skip(2);
  addDeviceHistory(sheet, device);
  addStatement(sheet, quantityTable(device));
  addStatement(sheet, congruenceTable(device));
  sheet.balance();
}

QString spanText(const DeviceHistory& device) {
  return Report::tr("%1 to %2")
      .arg(visibleLine(device.epochs.front().date), visibleLine(device.epochs.back().date));
}

std::string jsonOf(const DeviceHistory& device) {
  return historyJson(deviceName(device), DeviceHistories{{device}, {}}, {});
}

}  // namespace

void addDeviceHistory(ReportSheet& sheet, const DeviceHistory& device) {
  const QuantityHistory& intersection = device.quantities.front();
  sheet.heading(Report::tr("Δd over time"));
  QStringList lines;
  for (const std::string& sentence : historySentences(intersection.history, intersection.unit))
    lines.append(visibleLine(sentence));
  sheet.paragraph(Report::sentences(lines));
  sheet.skip(2);
  addHistoryChart(sheet, intersection);
  addStatement(sheet, sessionTable(device));
}

Result<QString> writeDeviceHistory(const DeviceHistory& device, const QString& outPath,
                                   const QStringList& inputs, const ReportPaper& paper,
                                   const QDateTime& date) {
  const auto painted = paintedPdf(paper, [&](QPagedPaintDevice& pages) {
    return paintSheets(
        pages,
        {.product = Report::tr("Alidade %1 · Device history").arg(qText(versionAndBuild())),
         .session = qText(deviceName(device)),
         .fileName = Report::tr("Sessions: %1, %2").arg(device.epochs.size()).arg(spanText(device)),
         .fingerprint = {},
         .date = date.toString(QStringLiteral("yyyy-MM-dd HH:mm"))},
        paper.margins, [&](ReportSheet& sheet) { layOut(sheet, device); });
  });
  if (!painted)
    return Problem{Report::tr("%1 cannot be written: painting failed").arg(outPath).toStdString()};
  const std::string pdf =
      archivedPdf(*painted,
                  {.title = Report::tr("Device history: %1").arg(shortLine(qText(deviceName(device)), 300)),
                   .author = {},
                   .creator = qText("Alidade " + versionAndBuild()),
                   .date = date},
                  {{.fileName = QStringLiteral("history.json"),
                    .description = Report::tr("The results of this device history, to be read by programs"),
                    .bytes = jsonOf(device)}});
  std::vector<std::string> read = encodedPaths(inputs);
  for (const Epoch& epoch : device.epochs) read.push_back(epoch.file);
  if (auto problem = writeFile(encodedPath(outPath), pdf, read)) return *std::move(problem);
  return outPath;
}

}  // namespace alidade::ui
