#pragma once

#include <optional>
#include <vector>

#include "core/adjustment/result/session_fit.h"

namespace alidade {

// Slips in what was typed about the set-up: the unit of a length, the kind of the vertical circle, the axis
// of a position. Each leaves readings that agree with one another and a Δd of the wrong size or sign.

/// Why the lengths may not be what they are taken for; empty where nothing speaks against them. No verdict
/// rests on lengths in doubt. `arcs` as each was fitted alone, its radius free. In doubt are
/// - a radius more than 20 % off the nominal one and more than 3 σ beyond that: no guideway is made and no
///   distance measured that badly, while slips are larger (inch for mm 25, diameter for radius 2). Smaller
///   differences have a finding of their own, for R0 may be no more than a round number;
/// - a distance below 100 mm, at which no theodolite focuses, its radius typed in the same unit or not.
std::optional<LengthsInDoubt> doubtfulLengths(const Measurement& measurement,
                                              const std::vector<ArcFit>& arcs);

/// Findings on the set-up of a fit that stands, `measurement` being the fitted part: too short a distance,
/// places on the wrong side of their centre (0° has them above, 180° below), a pointing zero where the other
/// kind of vertical circle has it, one that moved while the position was read or whose face 2 is left out,
/// different slider values in one visit.
std::vector<FitFinding> setupFindings(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
