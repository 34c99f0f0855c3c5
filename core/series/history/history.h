#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace alidade {

// The situation: one quantity x was measured at several dates, each time with its standard uncertainty u.
// Is it the same? The mean, weighted by 1/u²,
//
//   x̄ = Σ w x/Σ w,  w = 1/u²,  χ² = Σ w (x − x̄)²,  f = n − 1,
//
// answers where χ² is no accident: χ² is more than chance has it with p. Where it is not the same, what
// became of it? Five accounts of the values are rivals: it is constant, it went in steps, it has a trend, one
// value is off, it wanders (Brownian motion). Each has its evidence, over all dates of the steps, sizes of
// the changes and noise s u, s ≥ 1 (less where a part of u may not be there at all); the odds beforehand
// stand in `course_evidence.h`. A change is told where its account is `oddsToTell` times as probable as the
// constant one.

/// One value of the quantity.
struct DatedValue {
  std::string date;     ///< as it was written
  double day = 0;       ///< from 2000-01-01
  double value = 0;     ///< in the unit of the quantity
  double u = 0;         ///< its standard uncertainty, > 0
  double apart = 0;     ///< of that, what it does not share with all other values: by this they are compared
  std::string of = {};  ///< session or source; may be empty
  /// What it certainly has of `apart`; 0: all of it. Between the two the scatter that is seen tells.
  double least = 0;
};

/// What became of the quantity.
enum class Course { Constant, Steps, Trend, OddValue, Wander };

/// "constant", "steps", "trend", "odd_value", "wander".
const char* nameOf(Course course);

/// A date from which on the quantity is another one.
struct HistoryStep {
  std::size_t first = 0;                          ///< index of the first value after it
  std::string date;                               ///< of that value
  std::size_t earliest = 0, latest = 0;           ///< the same within 95 %
  double size = 0, u = 0;                         ///< level after less level before
  std::size_t valuesBefore = 0, valuesAfter = 0;  ///< behind the two levels
};

struct HistoryMean {
  double value = 0;
  double u = 0;          ///< by the stated ones, with what the values share
  double scattered = 0;  ///< the same with the scatter that is seen, where that is larger
};

/// x = … + rate · t, weighted by 1/u².
struct HistoryTrend {
  double perYear = 0;
  double u = 0;                    ///< by the larger of stated and seen scatter about the line
  double stated = 0;               ///< by the stated one alone
  double atMean = 0, meanDay = 0;  ///< the line passes there
};

/// How probable an account is among the five.
struct CourseProbability {
  Course course = Course::Constant;
  double probability = 0;
};

/// Control chart of the values in their order, about their mean.
struct ControlChart {
  double seenSigma = 0;  ///< mean moving range/1.128 (n = 2); NaN of one value
  struct Point {
    double shewhart = 0;             ///< half the width of its limits by the stated u: 3 u
    double ewma = 0, ewmaLimit = 0;  ///< its exponentially weighted average, and half the width of its limits
    bool isOut = false;              ///< of its Shewhart limits by the stated u
    bool isEwmaOut = false;
  };
  std::vector<Point> points;
};

/// Weight of the latest value in the exponentially weighted average.
inline constexpr double ewmaWeight = 0.2;
/// Half the width of all limits in σ.
inline constexpr double limitSigmas = 3;
/// A change is told where it is so many times as probable as none.
inline constexpr double oddsToTell = 5;

struct History {
  std::vector<DatedValue> values;  ///< by date; of one date in the order given
  HistoryMean mean;
  double chiSquare = 0;
  int degreesOfFreedom = 0;
  std::optional<double> chance;            ///< p; absent of one value
  double birgeRatio = 1;                   ///< √(χ²/f); 1 of one value
  std::vector<CourseProbability> courses;  ///< the most probable first; empty of fewer than three dates
  Course course = Course::Constant;        ///< that is told
  std::vector<HistoryStep> steps;          ///< where steps are told
  std::vector<double> levels;              ///< between them, one more
  std::optional<HistoryTrend> trend;       ///< whatever is told; absent where all values are of one date
  std::optional<std::size_t> oddValue;     ///< where one is told
  double scatter = 1;       ///< s about what is told, by which sizes of steps and rates are scaled
  double leastScatter = 1;  ///< that s cannot be below: 1, or less where `DatedValue::least` is
  ControlChart chart;
  /// p ≥ 0.05 and no change is told; absent of one value, which nothing compares.
  std::optional<bool> stable;
};

/// p below which χ² is no accident.
inline constexpr double leastChance = 0.05;

/// `values`: at least one, in any order, each with u > 0 and 0 < apart ≤ u. `shared`: the standard
/// uncertainty that all have in common, in the mean alone.
History historyOf(std::vector<DatedValue> values, double shared = 0);

}  // namespace alidade
