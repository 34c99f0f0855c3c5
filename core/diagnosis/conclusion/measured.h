#pragma once

#include <optional>

#include "core/diagnosis/conclusion/answer.h"
#include "core/diagnosis/gap/every_effect.h"

namespace alidade {

/// Δd, measured, averaged over all possible explanations, and the average scales of the plausible sizes
/// over the same explanations.
struct MeasuredWithEffects {
  MeasuredIntersection intersection;
  EffectScales scales;
};

/// Δd, measured, in one rigid guideway, with every effect of the catalogue (`everyEffect`). It is an average
/// weighted by posterior probability. The average is over every explanation that the search found or that is
/// a look-alike of the answer, and over the sizes of the effects of each source (`possibleScales`). A pattern
/// is estimated too. The effects are linear in a large session (`isLarge`). Absent without both positions, or
/// if the readings do not determine Δd.
std::optional<MeasuredWithEffects> measuredIntersection(const Inquiry& inquiry, const Answer& answer);

}  // namespace alidade
