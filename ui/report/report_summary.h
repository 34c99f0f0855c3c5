#pragma once

#include <QDateTime>

#include "ui/jobs/evaluation.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// The front page: who, what, when and with what; the result with its verdict; how the numbers were made;
/// signatures. What the session does not state is printed as a dash.
void addSummary(ReportSheet& sheet, const Evaluation& evaluation, const QDateTime& date);

}  // namespace alidade::ui
