#pragma once

#include "ui/jobs/gap.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// What was known beforehand of instrument and device: each number with its u, where it is known from and of
/// which day, and what these readings say of it; the instrument record by name. Nothing where nothing is
/// known.
void addKnown(ReportSheet& sheet, const Gap& gap);

}  // namespace alidade::ui
