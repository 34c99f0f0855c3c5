#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// U that sessions like the one of `model` have: its places read with noise so many times as large as the
/// model has it, every effect of the catalogue as known, or `scales` of its plausible size, what the model
/// has found as uncertain as it was before. The first is that of the readings as they are; then, the least
/// first, with more read or an effect known, what brings it down to nine tenths or less; of measures taken
/// together each has to bring as much. Empty without both positions, or where there are so many rows
/// (`isLarge`) that nobody would wait for it.
std::vector<AttainableUncertainty> attainableUncertainties(const GapModel& model, double noise,
                                                           const EffectScales& scales = {});

/// The first of them alone, and in a fraction of the time.
std::optional<double> attainableAsItIs(const GapModel& model, double noise);

}  // namespace alidade
