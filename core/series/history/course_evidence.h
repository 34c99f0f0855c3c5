#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/series/history/history.h"
#include "core/series/history/step_search.h"

namespace alidade {

// How probable each course of the values is (`Course`). With ū the median of the stated u:
//
// - Every course has the noise s u, with one s for all values: s = 1 with prior probability 0.7, else above
//   it, with the density 1/s². So values that scatter more than stated do not look like a series of steps. If
//   a part of u may be absent, this 0.7 is spread uniformly in log s from its smallest value to 1.
// - The size of a change (a step, a trend's change over all dates, an odd value's deviation, the wandering
//   over all dates) has a Cauchy distribution of scale 3 s ū.
// - The prior probability of constant is 1/2, of steps 1/4 (one 3/4 of it, two 3/16, …), of a trend 1/8, of
//   an odd value and of wandering 1/16 each. Every date may be that of a step, every value the odd one.
//
// Levels and lines are integrated in closed form, with a flat prior for the level and the prior density of a
// size taken at its best value; s and the rate of wandering are integrated numerically. The best dates of
// each number of steps are exact; the sum runs over the dates of each step with the others fixed.

/// The most probable dates of a given number of steps.
struct SteppingEvidence {
  Stepping stepping;
  /// [step][date]: probability that the date is the first after the step, with the other steps fixed.
  std::vector<std::vector<double>> places;
};

struct CourseEvidence {
  std::vector<CourseProbability> courses;    ///< the most probable first
  std::optional<SteppingEvidence> stepping;  ///< the most probable number of steps
  std::size_t oddValue = 0;                  ///< the most probable one

  double of(Course course) const;
};

/// A value for the evidence: its date index, and its value from a common centre, in units of ū.
struct ScaledValue {
  std::size_t date = 0;
  double years = 0;  ///< from the first date
  double x = 0, u = 1;
};

/// Values by date, with at least three dates. `leastScatter`: lower limit of s, in (0, 1].
CourseEvidence courseEvidence(const std::vector<ScaledValue>& values, double leastScatter = 1);

}  // namespace alidade
