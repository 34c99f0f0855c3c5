#pragma once

#include <optional>

#include "core/diagnosis/conclusion/answer.h"

namespace alidade {

/// Δd afterwards, averaged over all that may be the case, each as likely as it is: every explanation that was
/// found, and whatever looks like a cause in its place; but under larger noise nothing besides. σ holds what
/// they differ by; U is kσ, or farther where ± U would not hold the coverage of what is then believed of Δd.
/// That of the answer alone where the others do not matter. Beside an unknown cause: over what looks like the
/// causes, and what the pattern moves Δd by is part of σ.
std::optional<IntersectionEstimate> modelAveragedIntersection(const Inquiry& inquiry, const Answer& answer);

/// Δd as it was measured: the same, with every effect of the catalogue there besides, as large as it may be
/// (`everyEffect`), in one rigid guideway. Whether these effects are there is not asked.
std::optional<MeasuredIntersection> measuredIntersection(const Inquiry& inquiry, const Answer& answer);

}  // namespace alidade
