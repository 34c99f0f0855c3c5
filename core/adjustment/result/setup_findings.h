#pragma once

#include <optional>
#include <vector>

#include "core/adjustment/result/session_fit.h"

namespace alidade {

// Slips in the typed set-up data: the unit of a length, the kind of the vertical circle, the axis of a
// position. Each leaves readings that agree with one another and a Δd of the wrong size or sign.

/// Why the typed lengths may be wrong; empty if there is no indication. Lengths in doubt allow no verdict.
/// `arcs` are each fitted alone, with free radii. In doubt are
/// - a radius more than 20 % off the nominal one and more than 3 σ beyond that: no guideway is made and no
///   distance measured that badly, while slips are larger (inch for mm 25, diameter for radius 2). Smaller
///   differences have a finding of their own, as R0 may be just a round number;
/// - a distance below 100 mm, at which no theodolite focuses, its radius typed in the same unit or not.
std::optional<LengthsInDoubt> doubtfulLengths(const Measurement& measurement,
                                              const std::vector<ArcFit>& arcs);

/// Findings on the set-up after a fit, with `measurement` the fitted part. They concern too short a distance,
/// and places on the wrong side of their centre (0° has them above, 180° below). They concern a pointing zero
/// that fits the other kind of vertical circle, that moved while the position was read, or whose face 2 is
/// ignored. They concern different slider values in one visit.
std::vector<FitFinding> setupFindings(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
