#include <algorithm>
#include <cmath>

#include "core/base/list_text.h"
#include "core/base/phrase.h"
#include "core/base/quantity_text.h"
#include "core/statement/gap.h"
#include "core/wording/attainable.h"
#include "core/wording/effect_name.h"
#include "core/wording/measure.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

/// "shows a and b", "separates every two of a, b and c; one answer is left with a probability of 90 %".
std::string whatItTells(const Advice& advice) {
  const std::string names = causeNames(advice.separates, Phrase::of(" and ")),
                    sigmas = displayText(advice.bySigma, 1);
  if (advice.ofUndetectable) return Phrase::of("would show %1 by %2 σ or more", names, sigmas);
  const std::string text = advice.separates.size() == 2
                               ? Phrase::of("separates %1 by %2 σ or more", names, sigmas)
                               : Phrase::of("separates every two of %1 by %2 σ or more", names, sigmas);
  if (!(advice.oneLeft > 0)) return text;
  return Phrase::of("%1; one answer is left with a probability of %2", text,
                    shortProbabilityText(advice.oneLeft));
}

}  // namespace

Statement gapAdvice(const Gap& gap) {
  const Diagnosis& diagnosis = *gap.diagnosis;
  const auto rows = static_cast<double>(gap.evaluation->examined.measurement->rows);
  Statement statement{.id = "advice",
                      .title = Phrase::of("What to measure next"),
                      .columns = {{"measures", Phrase::of("Measure"), Statement::Column::Role::Name},
                                  {"rows", Phrase::of("rows, about")},
                                  {"tells", Phrase::of("What it tells"), Statement::Column::Role::Text}},
                      .rows = {}};
  for (const Advice& advice : worthwhileAdvice(diagnosis))
    statement.rows.push_back(
        {.cells = {withCapital(howTo(advice.measures)),
                   displayText(std::max(1.0, std::round(rows * effortOf(advice.measures))), 0),
                   whatItTells(advice)}});
  if (statement.rows.empty())
    statement.sentences.push_back(Phrase::of("No further reading of the usual kinds would tell more."));
  if (std::string attainable = attainableSentence(diagnosis.attainable); !attainable.empty())
    statement.sentences.push_back(std::move(attainable));
  return statement;
}

}  // namespace alidade
