#include "core/statement/journal.h"

#include <algorithm>

#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/wording/journal.h"

namespace alidade {

namespace {

using Role = Statement::Column::Role;

constexpr std::size_t longestText = 64, longestOrigin = 1000;

Statement::Row rowOf(const JournalEntry& entry, const Session& session, const JournalPlaceNamer& nameOf) {
  const bool isImport = entry.why == journal_reasons::imported;
  return {{visibleText(timeText(entry.at)), visibleText(nameOf(entry)),
           shortened(reasonText(entry, session), longestText), shortened(entry.by, longestText),
           shortened(contentText(entry, entry.from), longestText),
           shortened(contentText(entry, entry.to), isImport ? longestOrigin : longestText)}};
}

}  // namespace

Statement journalTable(const Session& session, const std::string& summary, const JournalPlaceNamer& nameOf,
                       std::size_t most) {
  Statement statement{.id = "journal",
                      .title = Phrase::of("Journal of changes"),
                      .columns = {{"when", Phrase::of("When (UTC)"), Role::Name},
                                  {"what", Phrase::of("What"), Role::Word},
                                  {"why", Phrase::of("Why"), Role::Word},
                                  {"who", Phrase::of("Who"), Role::Word},
                                  {"from", Phrase::of("From"), Role::Word},
                                  {"to", Phrase::of("To"), Role::Remark}},
                      .rows = {}};
  const std::vector<JournalEntry>& journal = session.journal;
  const std::size_t left = journal.size() - std::min(journal.size(), most);
  for (std::size_t i = left; i < journal.size(); ++i)
    if (journal[i].why != journal_reasons::explained)
      statement.rows.push_back(rowOf(journal[i], session, nameOf));
  if (!summary.empty()) statement.sentences.push_back(visibleText(summary));
  if (left > 0)
    statement.note = left == 1 ? Phrase::of("1 earlier entry is in the session file.")
                               : Phrase::of("%1 earlier entries are in the session file.", left);
  return statement;
}

}  // namespace alidade
