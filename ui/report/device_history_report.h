#pragma once

#include <QDateTime>
#include <QString>

#include "core/base/result.h"
#include "core/series/history/device_history.h"
#include "ui/report/report_paper.h"

namespace alidade::ui {

class ReportSheet;

/// Writes the history of a device as a document of its own, a PDF/A-3b with the history as JSON in it: what
/// Δd did, its control chart, every session, the other quantities, and each session compared with the next.
/// Never over one of the sessions. Answers with the path, or says why it could not be written.
Result<QString> writeDeviceHistory(const DeviceHistory& device, const QString& outPath,
                                   const QStringList& inputs, const ReportPaper& paper = {},
                                   const QDateTime& date = QDateTime::currentDateTime());

/// The same on the pages of another report: what Δd did, its control chart, and the sessions.
void addDeviceHistory(ReportSheet& sheet, const DeviceHistory& device);

}  // namespace alidade::ui
