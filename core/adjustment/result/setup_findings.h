#pragma once

#include <optional>
#include <vector>

#include "core/adjustment/result/session_fit.h"

namespace alidade {

// Errors in the typed set-up data: the unit of a length, the kind of the vertical circle, the axis of a
// position. The readings still agree with one another, but Δd has the wrong size or sign.

/// Why the typed lengths may be wrong; empty if there is no indication. Lengths in doubt allow no verdict.
/// `arcs` are each fitted alone, with free radii. In doubt are
/// - a radius that differs from the nominal one by more than 20 % plus 3 σ. Neither guideway nor distance is
///   that wrong, but a typing error is: inch for mm by a factor of 25, diameter for radius by 2. Smaller
///   differences have a finding of their own, as R0 may be just a round number;
/// - a distance below 100 mm, at which no theodolite focuses, whatever the unit of the typed radius.
std::optional<LengthsInDoubt> doubtfulLengths(const Measurement& measurement,
                                              const std::vector<ArcFit>& arcs);

/// Findings on the set-up after a fit, with `measurement` the fitted part: too short a distance; places on
/// the wrong side of their centre (0° has them above, 180° below); a pointing zero that fits the other kind
/// of vertical circle, that moved during the readings, or whose face 2 is ignored; zeros whose mark is
/// unstated; readings rounded more coarsely than their stated σ; different slider values in one visit.
std::vector<FitFinding> setupFindings(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
