#pragma once

#include "core/statement/statement.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// A section: the title, the table over the whole width with totals in bold, sentences and note. Draws
/// nothing if there are neither rows nor sentences.
void addStatement(ReportSheet& sheet, const Statement& statement);

}  // namespace alidade::ui
