#pragma once

#include "core/evaluation/evaluation.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// Every reading as typed, position by position, with the adjusted arc angle and the residuals.
void addReadings(ReportSheet& sheet, const Evaluation& evaluation);

/// Used if the readings are left out: the rows a report must list, namely changed, excluded or unusable ones.
/// Empty if there are none.
void addRemarkableReadings(ReportSheet& sheet, const Evaluation& evaluation);

}  // namespace alidade::ui
