#pragma once

#include <vector>

#include "core/diagnosis/plan_review.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/sighting_plan.h"
#include "core/evaluation/gap.h"
#include "core/guidance/outlook.h"
#include "core/statement/statement.h"

namespace alidade {

// What to measure next, as one statement wherever it is told (also `gapAdvice`): each measure with its rows
// and minutes, U afterwards, and what it separates or reveals. At most three, none of which another one beats
// in effort and both parts of worth, the most worth per minute first; then two known effects that reduce U
// most. Worth is that of a sighting (`NextSighting`): of causes half the probability that one of the
// look-alikes is left, or whether an undetectable effect is there; and −ln(U after/U before).

/// The measures that `gapAdvice` names, in its order. `gap` has a diagnosis.
std::vector<std::vector<Measure>> measuresNext(const Gap& gap);

/// What to add to a plan without readings: every separated pair counts by the number of effects.
Statement planAdvice(const PlanReview& review, const SessionEffort& session);

/// What helps if more rounds do not; empty if nothing does.
Statement insteadStatement(const Outlook& outlook);

/// Gives a statement without a table one of these measures and known effects with U; the first of the list is
/// none.
void addUncertainties(Statement& statement, const std::vector<AttainableUncertainty>& attainable);

}  // namespace alidade
