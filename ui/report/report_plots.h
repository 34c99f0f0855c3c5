#pragma once

#include "ui/jobs/gap.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// The selected plots as vectors, by the drawing code of the screen, with captions; both on one page.
void addPlots(ReportSheet& sheet, const Gap& gap, bool hasArcs, bool hasResiduals);

}  // namespace alidade::ui
