#pragma once

#include <optional>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"

namespace alidade {

// A fast version of `fitJointly` for the usual case: a perfect instrument on perfect arcs whose radii are
// free.
//
// The arcs then share no estimated unknown, and each has its own normal equations in (Δx, Δy, R) and, with
// slider readings, the slider's zero. Arc angles are eliminated: every visit is at its foot point
// (foot_point.h), whose equations are closed forms. Both faces of a visit read the same, so each kind of
// reading has one row, weighted by its number of readings. Without slider readings, Gauss-Newton only
// confirms the minima of the single arcs; with slider readings it makes some three steps.
//
// The fast fit refuses error terms, a closed model, a common or known radius, repeats that share a circle,
// estimated zeros, excluded readings, a plane perpendicular to an inclined zero, and a start so far off that
// steps are long. The general fit handles these cases.

/// Absent if refused. Otherwise the result of `fitJointly`, to rounding.
std::optional<JointFit> fitJointlyFast(const Measurement& measurement, const std::vector<Circle>& starts,
                                       const JointFitOptions& options = {});

/// `fitJointly` without the fast fit, for comparison.
JointFit fitJointlyInGeneral(const Measurement& measurement, const std::vector<Circle>& starts,
                             const JointFitOptions& options = {});

}  // namespace alidade
