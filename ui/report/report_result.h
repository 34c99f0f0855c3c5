#pragma once

#include "ui/jobs/gap.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// The headline in a frame, alone in large type; then Δd, fit only, and the sentence.
void addVerdict(ReportSheet& sheet, const Gap& gap);

/// Every entry that could not be used, beside a red bar; nothing where all could.
void addProblems(ReportSheet& sheet, const Evaluation& evaluation);

/// Both arcs with standard uncertainties, the intersection, and the reference where one is given.
void addResult(ReportSheet& sheet, const Gap& gap);

/// The budget of the measurement, then that of Δd, fit only; nothing without an intersection.
void addUncertainty(ReportSheet& sheet, const Gap& gap);

}  // namespace alidade::ui
