#pragma once

#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// What was changed after it stood, in the order of the changes, and whether the journal is whole and the
/// session sealed; nothing where there is no journal.
void addJournal(ReportSheet& sheet, const Session& session);

}  // namespace alidade::ui
