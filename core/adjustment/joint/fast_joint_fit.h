#pragma once

#include <optional>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"

namespace alidade {

// The adjustment of `fitJointly` for the usual case, fast: a perfect instrument on perfect arcs whose radii
// are free.
//
// The arcs then share no estimated unknown, and each has its own normal equations in (Δx, Δy, R) and, with
// slider readings, the slider's zero. Arc angles are eliminated: every visit is at its foot point
// (foot_point.h), whose equations are closed forms. Both faces of a visit read the same, so each kind of
// reading has one row, counted as often as it was read. Gauss-Newton; the minima of the single arcs only need
// confirmation, and with slider readings some three steps.
//
// The fast fit refuses error terms, a common or known radius, excluded readings, a plane perpendicular to an
// inclined zero, and a start so far off that the first steps are long. The general one serves these.

/// Absent if refused. Otherwise the result of `fitJointly`, to rounding.
std::optional<JointFit> fitJointlyFast(const Measurement& measurement, const std::vector<Circle>& starts,
                                       const JointFitOptions& options = {});

/// `fitJointly` without the fast fit, for comparison.
JointFit fitJointlyInGeneral(const Measurement& measurement, const std::vector<Circle>& starts,
                             const JointFitOptions& options = {});

}  // namespace alidade
