#pragma once

#include "ui/jobs/evaluation.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// What was changed after it stood, in the order of the changes, and whether the journal is whole and the
/// session sealed; nothing where there is no journal.
void addJournal(ReportSheet& sheet, const Evaluation& evaluation);

}  // namespace alidade::ui
