#pragma once

#include "ui/jobs/gap.h"
#include "ui/report/acceptance_report.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// The front page: who, what, when and with what; the result with its verdict; signatures; and the method
/// where there is room for it, which is answered. What the session does not state is printed as a dash.
bool addSummary(ReportSheet& sheet, const Gap& gap, const ReportOptions& options);

/// How the numbers were made.
void addMethod(ReportSheet& sheet, const Evaluation& evaluation);

}  // namespace alidade::ui
