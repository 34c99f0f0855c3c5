#pragma once

#include <optional>
#include <vector>

#include "core/base/angle.h"

namespace alidade {

/// The coarsest usual step of a circle (of degrees, minutes, seconds, decimal degrees or gon) that divides
/// the differences of all readings and is coarser than `finest`. Absent where none does, or fewer than six
/// readings differ.
std::optional<Angle> readingStep(const std::vector<Angle>& readings, Angle finest);

/// What rounding to steps of g scatters readings by, 1σ: g/√12, of a uniform distribution over one step.
/// Source: JCGM 100:2008, 4.3.7.
Angle roundingSigma(Angle step);

}  // namespace alidade
