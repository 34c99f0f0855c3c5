#pragma once

#include <memory>

#include "core/evaluation/gap.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

class Plot;

/// A plot as vectors over the whole width, `height` mm high.
void addPlot(ReportSheet& sheet, const std::shared_ptr<Plot>& plot, double height);

/// The selected plots as vectors, by the drawing code of the screen, with captions; both on one page.
void addPlots(ReportSheet& sheet, const Gap& gap, bool hasArcs, bool hasResiduals);

}  // namespace alidade::ui
