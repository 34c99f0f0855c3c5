#pragma once

#include "core/evaluation/evaluation.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// Recorded changes in order, whether the journal is complete, and whether the session is sealed; empty
/// without a journal.
void addJournal(ReportSheet& sheet, const Evaluation& evaluation);

}  // namespace alidade::ui
