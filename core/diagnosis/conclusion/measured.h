#pragma once

#include <optional>

#include "core/diagnosis/conclusion/answer.h"
#include "core/diagnosis/gap/every_effect.h"

namespace alidade {

/// Δd as measured, and how large the effects besides are, averaged over what may be the case.
struct MeasuredWithEffects {
  MeasuredIntersection intersection;
  EffectScales scales;
};

/// Δd as measured: in one rigid guideway, with every effect of the catalogue besides (`everyEffect`),
/// averaged over every explanation that the search found or that looks like the answer, and over how large
/// the effects of each source are (`possibleScales`), each as likely as the readings leave it. A pattern is
/// estimated along. Of a large session (`isLarge`) the effects are taken as linear. Absent without both
/// positions, or where the readings do not determine Δd then.
std::optional<MeasuredWithEffects> measuredIntersection(const Inquiry& inquiry, const Answer& answer);

}  // namespace alidade
