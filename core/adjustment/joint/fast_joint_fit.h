#pragma once

#include <optional>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"

namespace alidade {

// The adjustment of `fitJointly` for the usual case, fast: a perfect instrument on perfect arcs whose radii
// are free.
//
// Then the arcs have nothing in common that is estimated, and each has its own normal equations in (Δx, Δy,
// R) and, with slider readings, the slider's zero. Arc angles are no unknowns: every visit stands at its foot
// point (foot_point.h), whose equations are closed forms. Both faces of a visit read alike, so that a visit
// has one row for each kind of reading, counted as often as it was read. Gauss-Newton; from the minima of the
// single arcs nothing is left to do but to look, and with slider readings some three steps.
//
// Refused, and left to the general adjustment: error terms or a radius that is common or known, readings that
// take no part, a plane square to an inclined zero, and a start so far off that the steps are not short from
// the first on.

/// Absent where refused. Otherwise what `fitJointly` answers, to rounding.
std::optional<JointFit> fitJointlyFast(const Measurement& measurement, const std::vector<Circle>& starts,
                                       const JointFitOptions& options = {});

/// `fitJointly` without this: to hold one against the other.
JointFit fitJointlyInGeneral(const Measurement& measurement, const std::vector<Circle>& starts,
                             const JointFitOptions& options = {});

}  // namespace alidade
