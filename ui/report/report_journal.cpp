#include "ui/report/report_parts.h"

#include <algorithm>

#include "core/wording/journal.h"
#include "ui/report/report_table.h"
#include "ui/report/report_text.h"
#include "ui/text/journal_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

void addJournal(ReportSheet& sheet, const Evaluation& evaluation) {
  constexpr std::size_t mostEntries = 200;
  constexpr int longestText = 64;      // records on paper quote a whole digest
  constexpr int longestOrigin = 1000;  // origin of an import; its digest comes last
  const std::vector<JournalEntry>& journal = evaluation.session.journal;
  if (journal.empty() && evaluation.journal.empty()) return;
  sheet.keepTogether(35);
  sheet.heading(Report::tr("Journal of changes"));
  if (const QString summary = visibleLine(evaluation.journal); !summary.isEmpty()) sheet.paragraph(summary);
  if (journal.empty()) return;
  sheet.skip(0.8);
  //: heads of the journal: when, what, from which text, to which, why and by whom it was changed
  ReportTable table(sheet, {{Report::tr("When (UTC)"), 28},
                            {Report::tr("What"), 50},
                            {Report::tr("From"), 28},
                            {Report::tr("To"), 28},
                            {Report::tr("Why"), 22},
                            {Report::tr("Who"), ReportSheet::width - 156}});
  table.head();
  const std::size_t left = journal.size() - std::min(journal.size(), mostEntries);
  for (std::size_t i = left; i < journal.size(); ++i) {
    const JournalEntry& entry = journal[i];
    table.row({visibleLine(timeText(entry.at)), journalPlace(entry), shortLine(entry.from, longestText),
               shortLine(entry.to, entry.why == journal_reasons::imported ? longestOrigin : longestText),
               visibleLine(reasonText(entry)), shortLine(entry.by, longestText)});
  }
  table.finish();
  if (left > 0)
    sheet.paragraph(left == 1 ? Report::tr("1 earlier entry is in the session file.")
                              : Report::tr("%1 earlier entries are in the session file.").arg(left),
                    type::small);
}

}  // namespace alidade::ui
