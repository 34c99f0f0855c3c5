#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/series/history/history.h"
#include "core/series/history/step_search.h"

namespace alidade {

// How probable each course of the values is (`Course`). With ū the median of the stated u:
//
// - Every course has the noise s u, with one s for all values. s = 1 has the prior probability 0.7; larger s
//   have the density 0.3/s². Values that scatter more than stated then need no steps to explain them. If a
//   part of u may be absent, the 0.7 is spread uniformly in log s, from the smallest s to 1.
// - The size of a change (a step, a trend's change over all dates, an odd value's deviation, the wandering
//   over all dates) has a Cauchy distribution of scale 3 s ū.
// - The prior probability is 1/2 for constant, 1/4 for steps (3/4 of it for one, 3/16 for two, …), 1/8 for a
//   trend, 1/16 each for an odd value and wandering. All step dates and odd values are equally probable.
//
// Levels and lines are integrated in closed form. The level has a flat prior; the prior density of a size is
// taken at the best size. s and the rate of wandering are integrated numerically. The search for the best
// dates of each number of steps is exact; the sum over dates varies one step and keeps the others fixed.

/// The most probable dates of a given number of steps.
struct SteppingEvidence {
  Stepping stepping;
  /// [step][date]: probability that the date is the first after the step, with the other steps fixed.
  std::vector<std::vector<double>> places;
};

struct CourseEvidence {
  std::vector<CourseProbability> courses;    ///< the most probable first
  std::optional<SteppingEvidence> stepping;  ///< the steps, in their most probable number
  std::size_t oddValue = 0;                  ///< index of the value that is most probably the odd one

  double of(Course course) const;
};

/// A value for the evidence: the index of its date, and the value from a common centre, in units of ū.
struct ScaledValue {
  std::size_t date = 0;
  double years = 0;  ///< from the first date
  double x = 0, u = 1;
};

/// `values`: sorted by date, with at least three dates. `leastScatter`: lower limit of s, in (0, 1].
CourseEvidence courseEvidence(const std::vector<ScaledValue>& values, double leastScatter = 1);

}  // namespace alidade
