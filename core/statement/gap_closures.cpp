#include <algorithm>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/statement/gap.h"
#include "core/wording/closures.h"
#include "core/wording/size_text.h"

namespace alidade {

namespace {

/// The note below the closures: their conditions, and the coverage of U.
std::string noteOf(const Measurement& measurement) {
  const std::string coverage = displayPercent(measurement.coverage);
  return hasRepeats(measurement)
             ? Phrase::of(
                   "If the arc is rigid, half a turn about an axis along x changes neither its radius nor "
                   "the x of its centre, and an arc measured again has not moved. R0 and the reference are "
                   "compared if their σ is stated. U at a coverage of %1 %.",
                   coverage)
             : Phrase::of(
                   "If the arc is rigid, half a turn about an axis along x changes neither its radius nor "
                   "the x of its centre. R0 and the reference are compared if their σ is stated. U at a "
                   "coverage of %1 %.",
                   coverage);
}

std::string outcomeOf(const Diagnosis& diagnosis) {
  if (diagnosis.closures.empty()) return Phrase::of("Both positions are needed to compare them.");
  if (std::string open = misclosureSentence(diagnosis); !open.empty()) return open;
  const bool failed =
      std::ranges::any_of(diagnosis.closures, [](const ClosureStep& step) { return fails(step.before); });
  return failed ? Phrase::of("With the causes in the model, these quantities agree.")
                : Phrase::of("For one rigid arc turned about a level axis, these quantities agree.");
}

}  // namespace

Statement gapClosures(const Gap& gap) {
  const Diagnosis& diagnosis = *gap.diagnosis;
  const double coverage = gap.evaluation->examined.measurement->coverage;
  Statement statement{.id = "closures",
                      .title = Phrase::of("Closures: what must agree"),
                      .columns = {{"closure", Phrase::of("Closure"), Statement::Column::Role::Name},
                                  {"misclosure", Phrase::of("fit only ± U")},
                                  {"sigmas", Phrase::of("size")}},
                      .rows = {},
                      .sentences = {outcomeOf(diagnosis)}};
  const bool hasCauses = !diagnosis.causes.empty();
  if (hasCauses) {
    statement.columns.push_back({"misclosure_after", Phrase::of("with the causes ± U")});
    statement.columns.push_back({"sigmas_after", Phrase::of("size")});
  }
  for (const ClosureStep& step : diagnosis.closures) {
    Statement::Row row{.cells = {nameInWords(step.before)}, .isNotable = step.isOpen()};
    const auto add = [&](const std::optional<Closure>& closure) {
      row.cells.push_back(closure ? sizeWithExpanded(closure->value, expandedOf(*closure, coverage), "mm")
                                  : "—");
      row.cells.push_back(closure ? displayText(closure->sigmas(), 1) + " σ" : "—");
    };
    add(step.before);
    if (hasCauses) add(step.after);
    statement.rows.push_back(std::move(row));
  }
  if (!statement.rows.empty()) statement.note = noteOf(*gap.evaluation->examined.measurement);
  return statement;
}

}  // namespace alidade
