#pragma once

#include <array>
#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "core/effects/catalogue.h"

namespace alidade {

// Whether an effect is there is one question; how large it may be, whether or not the readings show it, is
// another, and the one that an uncertainty answers.

/// The error terms of every effect of the catalogue that a session's readings may hold, each
/// as is known of it (`knownOf`), or at 1σ of its plausible size about zero. The other relation of the
/// vertical circle is a matter of the model, and the slider's effects are there only where it is read.
std::vector<EstimatedTerm> everyEffect(const Measurement& measurement);

/// Those of them that something is known of beforehand: a tilt of the plane, too, that may be square to an
/// inclined zero (`Measurement::isPlaneStated`).
std::vector<EstimatedTerm> knownTerms(const Measurement& measurement);

/// A model with what is known beforehand in it: each known number estimated along, as known as it is. What
/// the readings are expected to hold is no gap.
GapModel withKnownSizes(GapModel model);

/// So many rows that a fit of every effect along would take longer than anybody waits.
bool isLarge(const Measurement& measurement);

/// 1σ of the effects of each source in plausible sizes: how large they are altogether in this session.
struct EffectScales {
  double guideway = 1, instrument = 1, time = 1;

  double of(const Effect& effect) const;
  bool operator==(const EffectScales&) const = default;
};

/// So narrow that no effect takes part.
inline constexpr EffectScales noEffect{1e-6, 1e-6, 1e-6};

/// Scales before the readings are seen, with their probabilities, which add up to 1: as plausible, or three
/// times that, of all effects alike or of each source by itself. Either is as likely as the other. No scale
/// is below 1: small effects that the readings show say nothing of an effect that they cannot show.
struct PossibleScales {
  EffectScales scales;
  double probability = 0;
};
const std::vector<PossibleScales>& possibleScales();

/// A model with every effect estimated along, so many plausible sizes wide; what is estimated already, no
/// narrower than it is. A known size is as well known as stated.
GapModel withEveryEffect(GapModel model, const EffectScales& scales = {});

}  // namespace alidade
