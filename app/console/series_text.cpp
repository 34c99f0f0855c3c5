#include "app/console/series_text.h"

#include <cstddef>

#include "app/console/diagnosis_text.h"
#include "app/console/text_layout.h"
#include "core/base/list_text.h"
#include "core/session/own_effects.h"
#include "core/statement/gap.h"
#include "core/statement/series.h"
#include "core/wording/series_words.h"

namespace alidade::console {

namespace {

constexpr std::size_t mostRows = 200;  // rows of a table; --json has all

std::string shortened(Statement statement) {
  const std::size_t rows = statement.rows.size();
  if (rows <= mostRows) return statementText(statement);
  statement.rows.resize(mostRows);
  statement.sentences.push_back("and " + std::to_string(rows - mostRows) + " more rows; --json has all");
  return statementText(statement);
}

}  // namespace

std::string seriesText(const std::string& name, const SeriesDiagnosis& series) {
  std::string text = heading(name) + "\n" + paragraph(sentenceOf(series)) +
                     statementText(seriesStages(series)) + shortened(seriesCauses(series));
  for (const OfferedEffect& offered : series.offered)
    text += formsText({offered.form}) + "  in " + counted(offered.sessions.size(), "session") +
            "; --keep-form keeps it as " + ownId(offered.effect) + "\n";
  if (!series.causes.empty() || series.pattern) text += statementText(gapWhere(series.where));
  return text + shortened(seriesSessions(series)) + statementText(seriesAdvice(series)) +
         statementText(seriesUndetectable(series)) + findingsText(findingsOf(series));
}

}  // namespace alidade::console
