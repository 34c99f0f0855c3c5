#pragma once

#include <vector>

#include "core/diagnosis/component.h"
#include "core/diagnosis/diagnosis.h"

namespace alidade {

/// What moves Δd by less is not worth a word, mm.
inline constexpr double negligibleInfluence = 1e-5;

/// For the .cpp files of this room only. Effects that would leave less than `clearlyDifferent` σ at their
/// plausible size, by what that does to Δd; of an effect with two numbers in the direction that moves Δd
/// most, of a jump at the moment that does. `perReading` is ∂Δd/∂reading, mm per σ of the reading.
std::vector<UnseenEffect> unseenEffects(const Leftover& leftover, const std::vector<Component>& candidates,
                                        const Eigen::VectorXd& perReading);

}  // namespace alidade
