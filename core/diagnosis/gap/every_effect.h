#pragma once

#include <array>
#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "core/effects/catalogue.h"

namespace alidade {

// A diagnosis decides whether an effect exists. An uncertainty needs the possible size of every effect,
// whether or not the readings show it. These functions serve the uncertainty.

/// Returns the error terms of every effect that the readings may contain. Each has its known size (`knownOf`)
/// or a mean of 0 with its plausible size (1σ). Effects without a size, such as the other relation of the
/// vertical circle, are excluded. Slider effects need slider readings.
std::vector<EstimatedTerm> everyEffect(const Measurement& measurement);

/// Returns the terms of `everyEffect` with known sizes. They include the tilt of the plane if the session
/// does not state whether the plane is square to an inclined zero (`Measurement::isPlaneStated`).
std::vector<EstimatedTerm> knownTerms(const Measurement& measurement);

/// Returns the model with every known number as an unknown with its known uncertainty. Known effects are then
/// no part of the gap.
GapModel withKnownSizes(GapModel model);

/// Whether the session has too many rows for a fit of every effect in a reasonable time.
bool isLarge(const Measurement& measurement);

/// Scales of the plausible sizes (1σ) in this session, by source of the effects.
struct EffectScales {
  double guideway = 1, instrument = 1, time = 1;

  double of(const Effect& effect) const;
  bool operator==(const EffectScales&) const = default;
};

/// Scales so small that every effect is negligible.
inline constexpr EffectScales noEffect{1e-6, 1e-6, 1e-6};

/// Prior scales with their probabilities, which sum to 1. Scales are 1 or 3, for all effects together or for
/// each source separately; both alternatives are equally probable. No scale is below 1: visible small effects
/// give no information about undetectable effects.
struct PossibleScales {
  EffectScales scales;
  double probability = 0;
};
const std::vector<PossibleScales>& possibleScales();

/// Returns the model with every effect as an unknown with `scales` times its plausible size. Terms that are
/// already estimated keep at least their prior width; known sizes keep their stated uncertainty.
GapModel withEveryEffect(GapModel model, const EffectScales& scales = {});

}  // namespace alidade
