#pragma once

#include "core/evaluation/gap.h"
#include "ui/report/report_contents.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// The terms of the result: the measurand and its sign; the decision rule, its risk and who agreed it, if a
/// verdict is possible; excluded rows, counted with their notes; corrections; the temperature, if stated, and
/// its use; parts left out of the report.
void addTerms(ReportSheet& sheet, const Gap& gap, const ReportContents& contents);

}  // namespace alidade::ui
