#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/statement/gap.h"
#include "core/wording/effect_name.h"
#include "core/wording/size_text.h"

namespace alidade {

namespace {

std::string plausibleSizesText(const Required& required) {
  constexpr double least = 0.1;
  return required.plausibleSizes < least ? "< " + displayShortest(least)
                                         : displayText(required.plausibleSizes, 1);
}

}  // namespace

Statement gapRequired(const Gap& gap) {
  Statement statement{.id = "required",
                      .title = Phrase::of("Sizes that would explain Δd − reference"),
                      .columns = {{"effect", Phrase::of("Effect"), Statement::Column::Role::Name},
                                  {"size", Phrase::of("size")},
                                  {"plausible_sizes", Phrase::of("plausible sizes")},
                                  {"visible", Phrase::of("trace (σ)")}},
                      .rows = {}};
  for (const Required& required : gap.diagnosis->whatItWouldTake)
    statement.rows.push_back({.cells = {causeTitle(required.effect), sizeText(required.size, required.unit),
                                        plausibleSizesText(required), displayText(required.visibleSigma, 1)},
                              .id = required.effect});
  if (!statement.rows.empty())
    statement.note = Phrase::of(
        "Effects, each considered alone, that these readings do not exclude at that size, the most plausible "
        "first; trace: what the effect would leave in these readings.");
  return statement;
}

}  // namespace alidade
