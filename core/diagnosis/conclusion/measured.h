#pragma once

#include <optional>

#include "core/diagnosis/conclusion/answer.h"

namespace alidade {

/// Δd as it was measured: averaged as afterwards (`averaged`), with every effect of the catalogue there
/// besides, as large as it may be (`everyEffect`), in one rigid guideway. Whether these effects are there is
/// not asked. Of a large session (`isLarge`) they are taken as linear. Absent without both positions, or
/// where the readings do not determine Δd then.
std::optional<MeasuredIntersection> measuredIntersection(const Inquiry& inquiry, const Answer& answer);

}  // namespace alidade
