#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/diagnosis/session_evidence.h"
#include "core/statement/gap.h"
#include "core/statement/series.h"
#include "core/wording/effect_name.h"

namespace alidade {

namespace {

Statement tableOf(std::string id, std::string title, const std::vector<UndetectableEffect>& effects) {
  Statement statement{.id = std::move(id),
                      .title = std::move(title),
                      .columns = {{"effect", Phrase::of("Effect"), Statement::Column::Role::Name},
                                  {"influence", Phrase::of("moves Δd (mm)")},
                                  {"visible", Phrase::of("trace (σ)")}},
                      .rows = {}};
  for (const UndetectableEffect& effect : effects)
    statement.rows.push_back({.cells = {causeTitle(effect.effect),
                                        "± " + displayText(effect.influence, decimalsFor(effect.influence)),
                                        displayText(effect.visibleSigma, 1)},
                              .id = effect.effect});
  return statement;
}

}  // namespace

Statement gapUndetectable(const Gap& gap) {
  Statement statement =
      tableOf("undetectable", Phrase::of("Undetectable here"), gap.noticeablyUndetectable());
  if (statement.rows.empty())
    statement.sentences = {
        Phrase::of("An effect of plausible size that moved Δd noticeably would leave a trace.")};
  else
    statement.note = Phrase::of(
        "Each effect has its plausible size, which these readings are too weak to show: only a trace of more "
        "than %1 σ is detectable. U of Δd, fit only, does not include these effects; U of Δd, measured, "
        "includes those in its budget.",
        displayText(clearlySeparated(), 1));
  return statement;
}

Statement seriesUndetectable(const SeriesDiagnosis& series) {
  return tableOf("series_undetectable", Phrase::of("Undetectable in all sessions together"),
                 series.undetectable);
}

}  // namespace alidade
