#pragma once

#include "core/evaluation/gap.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// The forms of an effect of no catalogue: each in a sentence with what looks like it, where the model holds,
/// and its curve; then how far the gap shrinks. Empty if there is none.
void addForms(ReportSheet& sheet, const Gap& gap);

}  // namespace alidade::ui
