#pragma once

#include <QDateTime>
#include <QString>

#include "core/base/result.h"
#include "core/series/history/device_history.h"
#include "ui/report/report_paper.h"

namespace alidade::ui {

class ReportSheet;

/// Writes the history of a device as a separate PDF/A-3b with the history as JSON attached: changes of Δd,
/// its control chart, every session, the other quantities, and each session compared with the next. Never
/// replaces a session. Returns the path, or why writing failed.
Result<QString> writeDeviceHistory(const DeviceHistory& device, const QString& outPath,
                                   const QStringList& inputs, const ReportPaper& paper = {},
                                   const QDateTime& date = QDateTime::currentDateTime());

/// Adds the changes of Δd, its control chart and the sessions to another report.
void addDeviceHistory(ReportSheet& sheet, const DeviceHistory& device);

}  // namespace alidade::ui
