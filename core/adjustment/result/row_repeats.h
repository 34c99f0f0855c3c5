#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/adjustment/arc/arc_fit.h"
#include "core/session/measurement.h"

namespace alidade {

// Rows that hold the same pair of readings in the same face: one was copied, or chance has it so. Readings
// stand on a grid of whole seconds, or tenths, or what the instrument shows. A place that is read again some
// rounds later is read alike to the last digit by chance, the more often the coarser the grid beside the
// scatter; and so are places that lie as near to one another as they scatter. Both are counted with what is
// to be expected, and told where so many come about in fewer than one of a hundred arcs.

/// Rows of the session's position: the first of those alike, then each other one, in its order. Empty where
/// chance may have it so. `fit`: of the arc.
std::vector<std::pair<std::size_t, std::size_t>> repeatedRows(const Measurement& measurement,
                                                              const ArcMeasurement& arc, const ArcFit& fit);

/// The coarsest grid, rad, of seconds, minutes or gons that all differences of the angles `read` (rad) are
/// steps of; 0 where there is none as coarse as 0.001″.
double gridOf(const std::vector<double>& read);

/// Probability that two readings of the same angle, each with σ `scatter`, are alike on a grid; 0 without
/// one.
double chanceOfBeingAlike(double grid, double scatter);

}  // namespace alidade
