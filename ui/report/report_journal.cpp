#include "core/statement/journal.h"
#include "ui/report/report_parts.h"
#include "ui/report/report_sheet.h"
#include "ui/text/journal_text.h"

namespace alidade::ui {

void addJournal(ReportSheet& sheet, const Evaluation& evaluation) {
  constexpr std::size_t mostEntries = 200;
  const auto placeOf = [](const JournalEntry& entry) { return journalPlace(entry).toStdString(); };
  addStatement(sheet, journalTable(evaluation.session, evaluation.journal, placeOf, mostEntries));
}

}  // namespace alidade::ui
