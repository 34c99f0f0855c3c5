#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/series/history/history.h"
#include "core/series/history/step_search.h"

namespace alidade {

// How probable each account of the values is (`Course`). With ū the median of the stated u:
//
// - Every account has the noise s u, with one s for all values: s = 1 with 0.7 beforehand, else above it,
//   with the density 1/s². So values that scatter more than stated are no row of steps. Where a part of u may
//   not be there, the 0.7 are spread evenly over log s from the least that must be there to 1.
// - What a change is in size (a step, what a trend makes over all dates, an odd value, how far values wander
//   over all dates) has a Cauchy distribution of scale 3 s ū.
// - Beforehand constant is 1/2, steps 1/4 (one 3/4 of it, two 3/16, …), a trend 1/8, an odd value and
//   wandering 1/16 each. Every date may be that of a step, every value the odd one.
//
// Levels and lines are integrated over in closed form (flat, the level; at the best value, the density of a
// size), s and the rate of wandering numerically. The best dates of each number of steps are exact; over the
// places of each step, the others held, it is summed.

/// One way to step, as the values prefer it.
struct SteppingEvidence {
  Stepping stepping;
  /// For each step: how probable each first date after it is, from 1 to the last, the other steps held.
  std::vector<std::vector<double>> places;
};

struct CourseEvidence {
  std::vector<CourseProbability> courses;    ///< the most probable first
  std::optional<SteppingEvidence> stepping;  ///< the most probable number of steps
  std::size_t oddValue = 0;                  ///< the most probable one

  double of(Course course) const;
};

/// A value for the evidence: its number among the dates, centred, in units of ū.
struct ScaledValue {
  std::size_t date = 0;
  double years = 0;  ///< from the first date
  double x = 0, u = 1;
};

/// By date; at least three dates. `leastScatter`: in (0, 1], that s cannot be below.
CourseEvidence courseEvidence(const std::vector<ScaledValue>& values, double leastScatter = 1);

}  // namespace alidade
