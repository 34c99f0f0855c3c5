#pragma once

#include "ui/jobs/gap.h"
#include "ui/report/report_contents.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// On what terms the result is stated: the measurand and its sign; the decision rule, its risk and who agreed
/// it, where there is a verdict to be had; what was left out, counted with its notes; what was corrected for;
/// the temperature, where it is stated, and what was made of it; what the report leaves out.
void addTerms(ReportSheet& sheet, const Gap& gap, const ReportContents& contents);

}  // namespace alidade::ui
