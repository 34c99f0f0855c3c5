#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// The largest share of U that remains after a measure worth its effort.
inline constexpr double worthwhileShare = 0.9;

/// Returns the U that sessions like that of `model` attain. The noise is `noise` times that of the model.
/// Every catalogue effect has its known size or `scales` times its plausible size; estimated effects have
/// their prior uncertainty.
///
/// The first entry is for the readings as they are. The other entries, in ascending order, are for more
/// readings or a known effect that reduce U to `worthwhileShare` or less. A combination must also reduce the
/// U of each of its parts to this share. Empty without both positions, or for too many rows (`isLarge`).
std::vector<AttainableUncertainty> attainableUncertainties(const GapModel& model, double noise,
                                                           const EffectScales& scales = {});

/// Returns only the U of the first entry of `attainableUncertainties`, with `scales` 1; much faster.
std::optional<double> attainableAsItIs(const GapModel& model, double noise);

}  // namespace alidade
