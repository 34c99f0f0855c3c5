#pragma once

#include "ui/jobs/gap.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// What the diagnosis says: the verdict, each stage of the gap with Δd, and the causes with their numbers.
/// Nothing where model and readings agree and the model holds no effects, and where there is but noise: that
/// is told among the findings.
void addGap(ReportSheet& sheet, const Gap& gap);

/// What must agree, and by how much it does not, as modelled and with the causes; with a reference that has a
/// σ also what it would take of each effect to explain how far Δd is from it. Nothing where nothing can be
/// held against each other.
void addClosures(ReportSheet& sheet, const Gap& gap);

/// What Δd ± U cannot hold: effects that leave no clear trace in these readings, what a plausible size of
/// each would move Δd by, and what further readings would show them.
void addUnseen(ReportSheet& sheet, const Gap& gap);

}  // namespace alidade::ui
