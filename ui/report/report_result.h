#pragma once

#include "core/evaluation/gap.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// The headline in a frame, in large type; then Δd, fit only, and the sentence.
void addVerdict(ReportSheet& sheet, const Gap& gap);

/// Every unusable entry, with a red bar at its left; empty if there are none.
void addProblems(ReportSheet& sheet, const Evaluation& evaluation);

/// Both arcs with standard uncertainties, the intersection, and the reference, if given.
void addResult(ReportSheet& sheet, const Gap& gap);

/// The budget of Δd, measured, then of Δd, fit only; empty without an intersection.
void addUncertainty(ReportSheet& sheet, const Gap& gap);

}  // namespace alidade::ui
