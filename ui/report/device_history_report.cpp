#include "ui/report/device_history_report.h"

#include <QPagedPaintDevice>
#include <QPainter>
#include <cmath>

#include "core/base/atomic_file.h"
#include "core/base/version.h"
#include "core/series/history/history_json.h"
#include "core/series/history/history_sentences.h"
#include "ui/charts/history/history_plot.h"
#include "ui/document/encoded_path.h"
#include "ui/report/painted_pdf.h"
#include "ui/report/pdf_archive.h"
#include "ui/report/report_sheet.h"
#include "ui/report/report_table.h"
#include "ui/report/report_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/series_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr auto atRight = Qt::AlignRight;
constexpr double gapColumn = 4;  // mm, between a right-aligned column and a left-aligned one

QString chanceCell(double chance) {
  return chance < 0.0005 ? QStringLiteral("< 0.001") : numberText(chance, 3);
}

void addSentences(ReportSheet& sheet, const QStringList& lines) {
  sheet.paragraph(Report::sentences(lines));
}

void addHistoryChart(ReportSheet& sheet, const QuantityHistory& quantity) {
  constexpr double height = 92, unitsPerMillimetre = 96 / 25.4;
  sheet.keepTogether(height + 12);
  const QRectF area(0, sheet.y(), ReportSheet::width, height);
  const auto plot = std::make_shared<HistoryPlot>();
  plot->setStyle(printStyle(reportFontFamily()));
  plot->setHistory(quantity.history, qText(quantityName(quantity.id)), quantity.unit);
  plot->arrange(area.size() * unitsPerMillimetre);
  sheet.draw([plot, target = sheet.inDeviceUnits(area)](QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    plot->scene()->render(&painter, target, plot->scene()->sceneRect());
  });
  sheet.skip(height + 1.5);
  sheet.paragraph(
      Report::tr(
          "Control chart. Bars: ± 2 u of what a value does not share with the others. Broken lines: mean "
          "± 3 u of each value; dotted: three times the scatter that is seen by the moving range. EWMA: "
          "exponentially weighted average with λ = 0.2 and its exact limits. Over the year and its parts."),
      type::small);
}

void addSessions(ReportSheet& sheet, const DeviceHistory& device) {
  sheet.heading(Report::tr("Sessions"));
  ReportTable table(sheet, {{Report::tr("Date"), 22},
                            {Report::tr("Session"), 60},
                            {Report::tr("Instrument"), 34},
                            {QStringLiteral("Δd ± U (mm)"), 30, atRight},
                            {QString(), gapColumn},
                            {Report::tr("Verdict"), 20}});
  table.head();
  for (const Epoch& epoch : device.epochs) {
    const QString instrument =
        visibleLine(epoch.instrumentSerial.empty() ? epoch.instrument : epoch.instrumentSerial);
    table.row({visibleLine(epoch.date), visibleLine(epoch.title), orNotStated(instrument),
               valueWithUncertainty(epoch.intersection.value, epoch.intersection.expanded, {}), QString(),
               orNotStated(ui::verdictText(epoch))});
  }
  table.finish();
  sheet.skip(1);
  addSentences(sheet, {qText(sharedSentence(device))});
}

QString courseCell(const History& history) {
  if (!history.stable) return Report::tr("one value");
  if (*history.stable) return Report::tr("stable");
  return history.course == Course::Constant ? Report::tr("scatters") : qText(courseName(history.course));
}

void addQuantities(ReportSheet& sheet, const DeviceHistory& device) {
  sheet.heading(Report::tr("Quantities"));
  ReportTable table(sheet, {{Report::tr("Quantity"), 44},
                            {Report::tr("Values"), 14, atRight},
                            {Report::tr("Weighted mean"), 50, atRight},
                            {QStringLiteral("χ²"), 16, atRight},
                            {QStringLiteral("p"), 16, atRight},
                            {QString(), gapColumn},
                            {Report::tr("Course"), 26}});
  table.head();
  for (const QuantityHistory& quantity : device.quantities) {
    const History& history = quantity.history;
    const HistoryNumbers numbers(history, quantity.unit);
    table.row({qText(quantityName(quantity.id)), QString::number(history.values.size()),
               qText(numbers.withUncertainty(history.mean.value, history.mean.u)),
               history.chance ? numberText(history.chiSquare, 1) : notStated(),
               history.chance ? chanceCell(*history.chance) : notStated(), QString(), courseCell(history)});
  }
  table.finish();
  sheet.skip(1);
  addSentences(sheet,
               {Report::tr("Standard uncertainties; all but that of Δd, measured, by the readings alone."),
                Report::tr("O1 and O2 refer to the theodolite: compare them only between set-ups on the same "
                           "pillar.")});
}

void addCongruences(ReportSheet& sheet, const DeviceHistory& device) {
  if (device.congruences.empty()) return;
  sheet.heading(Report::tr("Sessions compared"));
  ReportTable table(sheet, {{Report::tr("From"), 24},
                            {Report::tr("To"), 24},
                            {Report::tr("Δd changes by (mm)"), 36, atRight},
                            {QStringLiteral("p"), 16, atRight},
                            {Report::tr("Device: T of m"), 26, atRight},
                            {QStringLiteral("p"), 16, atRight},
                            {QString(), gapColumn},
                            {QString(), 24}});
  table.head();
  for (const Congruence& congruence : device.congruences) {
    const bool isNext = congruence.second == congruence.first + 1;
    if (!isNext && (congruence.first != 0 || congruence.second + 1 != device.epochs.size())) continue;
    const auto& test = congruence.device;
    table.row({visibleLine(device.epochs[congruence.first].date),
               visibleLine(device.epochs[congruence.second].date),
               valueWithUncertainty(congruence.difference, congruence.expanded, {}),
               chanceCell(congruence.chance),
               test ? Report::tr("%1 of %2").arg(numberText(test->statistic, 1)).arg(test->ids.size())
                    : notStated(),
               test ? chanceCell(test->chance) : notStated(), QString(),
               congruence.hasChanged                ? Report::tr("changed")
               : test && test->chance < leastChance ? Report::tr("differs")
                                                    : QString()});
  }
  table.finish();
  sheet.skip(1);
  addSentences(
      sheet,
      {Report::tr("Each session with the next, and the first with the last."),
       Report::tr("Δd, measured, with its expanded uncertainty; what both sessions share cancels."),
       Report::tr(
           "Device: (O1 − O2)/2 and the radii by the readings alone, T = dᵀC⁻¹d with the full covariance "
           "of both fits.")});
}

void layOut(ReportSheet& sheet, const DeviceHistory& device) {
  sheet.text(Report::tr("Device history"), type::title, 0, sheet.y(), ReportSheet::width);
  sheet.skip(sheet.lineHeight(type::title) + 0.5);
  sheet.paragraph(shortLine(deviceText(device), 300), type::subtitle);
  sheet.skip(2);
  addDeviceHistory(sheet, device);
  addQuantities(sheet, device);
  addCongruences(sheet, device);
  sheet.balance();
}

QString spanText(const DeviceHistory& device) {
  return Report::tr("%1 to %2")
      .arg(visibleLine(device.epochs.front().date), visibleLine(device.epochs.back().date));
}

std::string jsonOf(const DeviceHistory& device) {
  return historyJson(deviceText(device).toStdString(), DeviceHistories{{device}, {}}, {});
}

}  // namespace

void addDeviceHistory(ReportSheet& sheet, const DeviceHistory& device) {
  const QuantityHistory& intersection = device.quantities.front();
  sheet.heading(Report::tr("Δd over time"));
  QStringList lines;
  for (const std::string& sentence : historySentences(intersection.history, intersection.unit))
    lines.append(visibleLine(sentence));
  addSentences(sheet, lines);
  sheet.skip(2);
  addHistoryChart(sheet, intersection);
  addSessions(sheet, device);
}

Result<QString> writeDeviceHistory(const DeviceHistory& device, const QString& outPath,
                                   const QStringList& inputs, const ReportPaper& paper,
                                   const QDateTime& date) {
  const auto painted = paintedPdf(paper, [&](QPagedPaintDevice& pages) {
    ReportSheet sheet(
        pages,
        {.product = Report::tr("Alidade %1 · Device history").arg(qText(versionAndBuild())),
         .session = deviceText(device),
         .fileName = Report::tr("Sessions: %1, %2").arg(device.epochs.size()).arg(spanText(device)),
         .fingerprint = {},
         .date = date.toString(QStringLiteral("yyyy-MM-dd HH:mm"))},
        paper.margins);
    layOut(sheet, device);
    QPainter painter;
    return painter.begin(&pages) && sheet.paint(painter) && painter.end();
  });
  if (!painted)
    return Problem{Report::tr("%1 cannot be written: painting failed").arg(outPath).toStdString()};
  const std::string pdf =
      archivedPdf(*painted,
                  {.title = Report::tr("Device history: %1").arg(shortLine(deviceText(device), 300)),
                   .author = {},
                   .creator = qText("Alidade " + versionAndBuild()),
                   .date = date},
                  {{.fileName = QStringLiteral("history.json"),
                    .description = Report::tr("The history of this document, to be read by programs"),
                    .bytes = jsonOf(device)}});
  std::vector<std::string> read = encodedPaths(inputs);
  for (const Epoch& epoch : device.epochs) read.push_back(epoch.file);
  if (auto problem = writeFile(encodedPath(outPath), pdf, read)) return *std::move(problem);
  return outPath;
}

}  // namespace alidade::ui
