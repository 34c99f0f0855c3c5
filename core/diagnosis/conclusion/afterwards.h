#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/conclusion/answer.h"

namespace alidade {

/// Δd afterwards, averaged over all that may be the case, each as likely as it is: every explanation that was
/// found, and whatever looks like a cause in its place; but under larger noise nothing besides. σ holds what
/// they differ by; U is kσ, or farther where ± U would not hold the coverage of what is then believed of Δd.
/// That of the answer alone where the others do not matter. Beside an unknown cause: over what looks like the
/// causes, and what the pattern moves Δd by is part of σ.
std::optional<IntersectionEstimate> modelAveragedIntersection(const Inquiry& inquiry, const Answer& answer);

/// What may be the case instead of what an estimate holds.
struct Possible {
  double odds = 1;                 ///< against what the estimate holds
  double value = 0, variance = 0;  ///< of Δd, less those of the estimate: mm, mm²
};

/// `own` averaged over what may be the case, itself among that; `own` where the rest does not matter.
IntersectionEstimate averagedOver(const IntersectionEstimate& own, const std::vector<Possible>& all,
                                  double coverage);

/// `own` with so much more variance, mm², if that is positive.
IntersectionEstimate widerBy(IntersectionEstimate own, double variance);

/// An explanation of the inquiry, with whatever looks like a part of the answer in the place of that part:
/// in place of each, whatever stands in the places of the others. The explanation itself first; each has the
/// odds of its own.
std::vector<Explanation> withRivals(const Answer& answer, const Explanation& explanation);

/// The inquiry's explanation that an answer is made of; null where there is none.
const Explanation* explanationOf(const Inquiry& inquiry, const Answer& answer);

/// An explanation may be averaged over: the readings speak for each of its parts (what only might be there
/// besides is undetectable, and told apart), and under larger noise it is not what that noise stands for.
bool isOfAccount(const Explanation& explanation, const Answer& answer);

}  // namespace alidade
