#pragma once

#include <vector>

#include "core/diagnosis/plan_review.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/sighting_plan.h"
#include "core/evaluation/gap.h"
#include "core/guidance/outlook.h"
#include "core/statement/statement.h"

namespace alidade {

// What to measure next, as one statement (`gapAdvice`): each measure with its rows and minutes, U afterwards,
// and what it separates or reveals. Lists at most three measures, the most worth per effort first, then the
// two known effects that reduce U most. Omits a measure if another one is no worse in effort and in both
// parts of worth. The worth for causes is half the probability that one look-alike is left, plus the worth of
// showing undetectable effects. The worth for U is −ln(U after/U before).

/// The measures that `gapAdvice` names, in its order. `gap` has a diagnosis.
std::vector<std::vector<Measure>> measuresNext(const Gap& gap);

/// What to add to a plan. Each pair of effects separated is worth 1/(number of effects + 1).
Statement planAdvice(const PlanReview& review, const SessionEffort& session);

/// The measures and known effects that reduce U if more rounds do not; empty if there are none.
Statement insteadStatement(const Outlook& outlook);

/// Adds a table to a statement without one: a row with U for each entry except the first, which has neither
/// measures nor a known effect.
void addUncertainties(Statement& statement, const std::vector<AttainableUncertainty>& attainable);

}  // namespace alidade
