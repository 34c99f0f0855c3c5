#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace alidade {

// One quantity x was measured at several dates, each time with its standard uncertainty u. The mean weighted
// by 1/u² tests whether x has stayed the same:
//
//   x̄ = Σ w x/Σ w, w = 1/u², χ² = Σ w (x − x̄)², f = n − 1;
//
// p is the probability that chance alone exceeds χ². What happened to x is decided between five courses of
// the values: constant, changed in steps, with a trend, with one odd value, wandering (Brownian motion). The
// evidence of each course covers all dates of the steps, sizes of the changes and noise s u, s ≥ 1 (less if a
// part of u may be absent); `course_evidence.h` has the prior odds. A change is reported if its course is
// `oddsForChange` times as probable as the constant one.

/// How a session was judged, in the words of its headline.
struct Judgement {
  std::string verdict = {};    ///< "Accepted · tolerance ± 2.5 mm"; empty for a value without a session
  std::string condition = {};  ///< condition of the verdict, or why the verdict is open; may be empty
};

/// One value of the quantity.
struct DatedValue {
  std::string date;     ///< as written
  double day = 0;       ///< days from 2000-01-01
  double value = 0;     ///< in the unit of the quantity
  double u = 0;         ///< its standard uncertainty, > 0
  double apart = 0;     ///< the part of u that is not common to all values, used to compare values
  std::string of = {};  ///< name of the session or source; may be empty
  /// The part of `apart` that is certainly present; 0: all. The observed scatter decides about the rest.
  double least = 0;
  double expanded = 0;  ///< U at the history's coverage, for pictures and tables; 0: `factor` u
  Judgement judgement = {};
  std::string file = {};  ///< of the session; empty for a value of a table
};

/// The course of the quantity.
enum class Course { Constant, Steps, Trend, OddValue, Wander };

/// "constant", "steps", "trend", "odd_value", "wander".
const char* nameOf(Course course);

/// A change of the quantity from one level to another.
struct HistoryStep {
  std::size_t first = 0;                          ///< index of the first value after the step
  std::string date;                               ///< date of the first value after the step
  std::size_t earliest = 0, latest = 0;           ///< 95 % range of `first`
  double size = 0, u = 0, expanded = 0;           ///< level after minus level before, its u and its U
  std::size_t valuesBefore = 0, valuesAfter = 0;  ///< number of values in the two levels
};

/// The mean of the later date minus that of the earlier, by the stated u.
struct DateDifference {
  double value = 0, u = 0, expanded = 0;
};

struct HistoryMean {
  double value = 0;
  double u = 0;          ///< from the stated u, including the part common to all values
  double expanded = 0;   ///< U from `u`
  double scattered = 0;  ///< from the observed scatter if it is larger than stated, else equal to `u`
  double scatteredExpanded = 0;
};

/// The line x = `atMean` + `perYear` t, t in years from `meanDay`, fitted with weights 1/u².
struct HistoryTrend {
  double perYear = 0;
  double u = 0;                    ///< from the larger of stated and observed scatter about the line
  double expanded = 0;             ///< U from `u`
  double stated = 0;               ///< from the stated scatter only
  double atMean = 0, meanDay = 0;  ///< a point on the line
};

/// The probability of one course among the five.
struct CourseProbability {
  Course course = Course::Constant;
  double probability = 0;
};

/// Control chart of the values in order. Its centre line is the weighted mean of the baseline, which consists
/// of the first values. The limits of later values include the uncertainty u_c of the centre line. The
/// exponentially weighted average of the later values begins at the centre line.
struct ControlChart {
  std::size_t baseline = 0;        ///< number of values in the baseline; all if none was chosen
  double centre = 0, centreU = 0;  ///< the centre line, and its u_c from the `apart` of the values
  double seenSigma = 0;            ///< mean moving range/1.128 (n = 2) of the baseline; NaN for one value
  struct Point {
    double shewhart = 0;  ///< half the width of the limits: 3 u, for later values 3 √(u² + u_c²)
    double ewma = 0, ewmaLimit = 0;  ///< exponentially weighted average, and half the width of its limits
    bool isOut = false;              ///< outside the Shewhart limits
    bool isEwmaOut = false;
  };
  std::vector<Point> points;
};

/// Weight of the latest value in the exponentially weighted average.
inline constexpr double ewmaWeight = 0.2;
/// Half the width of all limits in σ.
inline constexpr double limitSigmas = 3;
/// A change is reported if it is this many times as probable as none.
inline constexpr double oddsForChange = 5;

struct History {
  std::vector<DatedValue> values;  ///< by date; within a date in the order given
  double coverage = 0.95;          ///< of each U in the history
  double factor = 1;  ///< coverage factor of a normal distribution; U from an observed scatter has Student's
  std::optional<double> tolerance = {};  ///< limit of |value|, if there is one
  HistoryMean mean;
  double chiSquare = 0;
  int degreesOfFreedom = 0;
  std::optional<double> chance;            ///< p; absent for one value
  double birgeRatio = 1;                   ///< √(χ²/f); 1 for one value
  std::vector<CourseProbability> courses;  ///< the most probable first; empty for fewer than three dates
  Course course = Course::Constant;        ///< the reported course
  std::optional<DateDifference> twoDates;  ///< only if there are just two dates: no course is then judged
  std::vector<HistoryStep> steps;          ///< empty unless steps are reported
  std::vector<double> levels;              ///< weighted means before, between and after the steps
  std::optional<HistoryTrend> trend;       ///< always fitted; absent if all values have one date
  std::optional<std::size_t> oddValue;     ///< index of the odd value, if one is reported
  double scatter = 1;                      ///< s about the reported course; scales the u of steps and rates
  double leastScatter = 1;                 ///< lower limit of s: 1, or less if `DatedValue::least` allows it
  ControlChart chart;
  /// True if p ≥ 0.05 and no change is reported. Absent for a single value.
  std::optional<bool> stable;
};

/// p below which χ² is significant.
inline constexpr double leastChance = 0.05;

/// The coverage if no session states a coverage.
inline constexpr double usualCoverage = 0.95;

/// `values`: at least one, in any order, each with u > 0 and 0 < apart ≤ u. `shared`: the standard
/// uncertainty common to all, which affects only the mean. `coverage`: in (0, 1).
History historyOf(std::vector<DatedValue> values, double shared = 0, double coverage = usualCoverage);

/// Makes the first `baseline` values the baseline of the chart; all values if 0 or more than there are.
void setBaseline(History& history, std::size_t baseline);

}  // namespace alidade
