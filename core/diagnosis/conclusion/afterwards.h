#pragma once

#include <optional>

#include "core/diagnosis/conclusion/answer.h"
#include "core/diagnosis/conclusion/linear_move.h"

namespace alidade {

/// Δd afterwards, averaged over all that may be the case, each as likely as it is: every explanation that was
/// found, and whatever looks like a cause in its place; but under larger noise nothing besides. σ holds what
/// they differ by; U is kσ, or farther where ± U would not hold the coverage of what is then believed of Δd.
/// That of the answer alone where the others do not matter. Beside an unknown cause: over what looks like the
/// causes, and what the pattern moves Δd by is part of σ.
std::optional<IntersectionEstimate> modelAveragedIntersection(const Inquiry& inquiry, const Answer& answer);

/// `own`, the Δd of a model with the answer, averaged over the same. `moves`: with what is in that model
/// besides the answer; where that is every effect, it may also be that nothing else is there.
IntersectionEstimate averaged(const Inquiry& inquiry, const Answer& answer, const IntersectionEstimate& own,
                              LinearMoves& moves);

}  // namespace alidade
