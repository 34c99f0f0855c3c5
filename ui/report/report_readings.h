#pragma once

#include "ui/jobs/evaluation.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// Every reading as typed, position by position, with the adjusted arc angle and the residuals.
void addReadings(ReportSheet& sheet, const Evaluation& evaluation);

/// Where the readings are left out: the rows of which the report may not keep silent, those that were
/// changed, excluded or cannot be used. Nothing where there are none.
void addRemarkableReadings(ReportSheet& sheet, const Evaluation& evaluation);

}  // namespace alidade::ui
