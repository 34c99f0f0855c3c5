#pragma once

#include "ui/jobs/gap.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// The plots that are wanted as vectors, drawn by the code that draws them on the screen, with captions; both
/// on a page of their own.
void addPlots(ReportSheet& sheet, const Gap& gap, bool hasArcs, bool hasResiduals);

}  // namespace alidade::ui
