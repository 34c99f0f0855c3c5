#pragma once

#include "core/evaluation/gap.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// Known sizes of instrument and device: each number with its u, source and date, and what these readings say
/// of it; the instrument record by name. Empty without known sizes.
void addKnown(ReportSheet& sheet, const Gap& gap);

}  // namespace alidade::ui
