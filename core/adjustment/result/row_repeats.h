#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/adjustment/arc/arc_fit.h"
#include "core/session/measurement.h"

namespace alidade {

// Rows with the same pair of readings in the same face are copied, or equal by chance. Readings are on a
// grid of whole seconds, or tenths, or the instrument's display step. A place that is read again some rounds
// later may repeat to the last digit. This is more frequent on a grid that is coarse relative to the scatter.
// Two places closer than the scatter may also read the same. Repeats of one place and of two places are
// counted separately, and reported if fewer than one of a hundred arcs has as many by chance.

/// Pairs of identical rows of the position: the first of a group and a further one, as indices into the
/// readings. Empty if chance explains them. `fit`: of the arc.
std::vector<std::pair<std::size_t, std::size_t>> repeatedRows(const Measurement& measurement,
                                                              const ArcMeasurement& arc, const ArcFit& fit);

/// The coarsest grid, rad, of seconds, minutes or gons that contains all differences of the angles `read`
/// (rad); 0 if there is none as coarse as 0.001″.
double gridOf(const std::vector<double>& read);

/// Probability that two readings of the same angle, each with σ `scatter`, are equal on a grid; 0 without a
/// grid.
double chanceOfBeingAlike(double grid, double scatter);

}  // namespace alidade
