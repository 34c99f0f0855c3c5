#pragma once

#include "ui/jobs/evaluation.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// A page with both plots as vectors, drawn by the code that draws them on the screen, with captions.
void addPlots(ReportSheet& sheet, const Evaluation& evaluation);

}  // namespace alidade::ui
