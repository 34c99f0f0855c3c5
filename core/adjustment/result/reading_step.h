#pragma once

#include <optional>
#include <vector>

#include "core/base/angle.h"

namespace alidade {

/// The coarsest usual step of a circle that divides the differences of all readings and is coarser than
/// `finest`. Steps are of degrees, minutes, seconds, decimal degrees or gon. Absent if there is none, or if
/// fewer than six readings differ.
std::optional<Angle> readingStep(const std::vector<Angle>& readings, Angle finest);

/// The scatter of readings due to rounding to steps of g, 1σ: g/√12, from a uniform distribution over one
/// step. Source: JCGM 100:2008, 4.3.7.
Angle roundingSigma(Angle step);

}  // namespace alidade
