#include "core/series/history/history.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/statistics.h"
#include "core/series/history/course_evidence.h"
#include "core/series/history/history_date.h"

namespace alidade {

namespace {

double weightOf(const DatedValue& value) {
  return 1 / (value.apart * value.apart);
}

double sumOfWeights(const std::vector<DatedValue>& values) {
  double sum = 0;
  for (const DatedValue& value : values) sum += weightOf(value);
  return sum;
}

double weightedMean(const std::vector<DatedValue>& values) {
  const double first = values.front().value;  // subtracted so that rounding does not hide a small u
  double sum = 0;
  for (const DatedValue& value : values) sum += weightOf(value) * (value.value - first);
  return first + sum / sumOfWeights(values);
}

double chiSquareAbout(const std::vector<DatedValue>& values, double mean) {
  double sum = 0;
  for (const DatedValue& value : values) sum += weightOf(value) * std::pow(value.value - mean, 2);
  return sum;
}

/// Numbers the dates of the values from 0; values of one day share a number.
std::vector<std::size_t> dateNumbers(const std::vector<DatedValue>& values) {
  std::vector<std::size_t> numbers(values.size(), 0);
  for (std::size_t i = 1; i < values.size(); ++i)
    numbers[i] = numbers[i - 1] + (values[i].day > values[i - 1].day ? 1 : 0);
  return numbers;
}

std::vector<ScaledValue> scaled(const History& history, const std::vector<std::size_t>& dates) {
  std::vector<double> us;
  for (const DatedValue& value : history.values) us.push_back(value.apart);
  const double unit = medianOf(us);
  std::vector<ScaledValue> values;
  for (std::size_t i = 0; i < dates.size(); ++i) {
    const DatedValue& value = history.values[i];
    values.push_back({dates[i], (value.day - history.values.front().day) / daysPerYear,
                      (value.value - history.mean.value) / unit, value.apart / unit});
  }
  return values;
}

/// The median share of `apart` that is certainly present.
double leastScatterOf(const std::vector<DatedValue>& values) {
  std::vector<double> shares;
  shares.reserve(values.size());
  for (const DatedValue& value : values)
    shares.push_back(value.least > 0 ? std::min(1.0, value.least / value.apart) : 1);
  return medianOf(std::move(shares));
}

/// The larger of the observed scatter and the lower limit of s; 1 without degrees of freedom.
double seenScatter(const History& history, double chiSquare, double freedom) {
  return freedom > 0 ? std::max(history.leastScatter, std::sqrt(chiSquare / freedom)) : 1;
}

/// U of a result of standard uncertainty `u`, which contains the scatter s.
double expandedBy(const History& history, double u, double scatter, double freedom) {
  const bool isObserved = freedom > 0 && scatter > history.leastScatter;
  return (isObserved ? coverageFactor(history.coverage, freedom) : history.factor) * u;
}

std::optional<HistoryTrend> trendOf(const History& history) {
  const double mean = history.mean.value;
  double w = 0, wt = 0;
  for (const DatedValue& value : history.values) {
    w += weightOf(value);
    wt += weightOf(value) * (value.day - history.values.front().day);
  }
  HistoryTrend trend{.atMean = mean, .meanDay = history.values.front().day + wt / w};
  double tt = 0, tx = 0;
  for (const DatedValue& value : history.values) {
    const double years = (value.day - trend.meanDay) / daysPerYear;
    tt += weightOf(value) * years * years;
    tx += weightOf(value) * years * (value.value - mean);
  }
  if (!(history.values.back().day > history.values.front().day) || !(tt > 0)) return std::nullopt;
  trend.perYear = tx / tt;
  trend.stated = 1 / std::sqrt(tt);
  double chiSquare = 0;
  for (const DatedValue& value : history.values)
    chiSquare += weightOf(value) *
                 std::pow(value.value - mean - trend.perYear * (value.day - trend.meanDay) / daysPerYear, 2);
  const auto freedom = static_cast<double>(history.values.size()) - 2;
  const double scatter = seenScatter(history, chiSquare, freedom);
  trend.u = trend.stated * scatter;
  trend.expanded = expandedBy(history, trend.u, scatter, freedom);
  return trend;
}

/// The first and last index of the 95 % range about `best`.
std::pair<std::size_t, std::size_t> likelyPlaces(const std::vector<double>& probabilities, std::size_t best) {
  constexpr double within = 0.95;
  std::size_t first = best, last = best;
  double sum = probabilities[best];
  while (sum < within) {
    const double before = first > 0 ? probabilities[first - 1] : 0;
    const double after = last + 1 < probabilities.size() ? probabilities[last + 1] : 0;
    if (before <= 0 && after <= 0) break;
    sum += std::max(before, after);
    if (before > after)
      --first;
    else
      ++last;
  }
  return {first, last};
}

struct Level {
  double mean = 0, variance = 0;
  std::size_t count = 0;
};

void addSteps(History& history, const SteppingEvidence& found, const std::vector<std::size_t>& dates) {
  std::vector<std::size_t> firstOfDate;  // index of the first value of each date
  for (std::size_t i = 0; i < dates.size(); ++i)
    if (firstOfDate.size() == dates[i]) firstOfDate.push_back(i);
  std::vector<std::size_t> bounds{0};
  for (const std::size_t date : found.stepping.firsts) bounds.push_back(firstOfDate[date]);
  bounds.push_back(dates.size());
  std::vector<Level> levels;
  double chiSquare = 0;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
    const std::vector<DatedValue> part(history.values.begin() + static_cast<std::ptrdiff_t>(bounds[i]),
                                       history.values.begin() + static_cast<std::ptrdiff_t>(bounds[i + 1]));
    levels.push_back({weightedMean(part), 1 / sumOfWeights(part), part.size()});
    history.levels.push_back(levels.back().mean);
    chiSquare += chiSquareAbout(part, levels.back().mean);
  }
  const double freedom = static_cast<double>(dates.size()) - static_cast<double>(levels.size());
  history.scatter = seenScatter(history, chiSquare, freedom);
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    const auto [earliest, latest] = likelyPlaces(found.places[i], found.stepping.firsts[i]);
    const double u = history.scatter * std::sqrt(levels[i].variance + levels[i + 1].variance);
    history.steps.push_back({.first = bounds[i + 1],
                             .date = history.values[bounds[i + 1]].date,
                             .earliest = firstOfDate[earliest],
                             .latest = firstOfDate[latest],
                             .size = levels[i + 1].mean - levels[i].mean,
                             .u = u,
                             .expanded = expandedBy(history, u, history.scatter, freedom),
                             .valuesBefore = levels[i].count,
                             .valuesAfter = levels[i + 1].count});
  }
}

/// `later`: index of the first value of the later date.
DateDifference differenceOf(const History& history, std::ptrdiff_t later) {
  const auto begin = history.values.begin();
  const std::vector<DatedValue> before(begin, begin + later), after(begin + later, history.values.end());
  const double u = std::sqrt(1 / sumOfWeights(before) + 1 / sumOfWeights(after));
  return {weightedMean(after) - weightedMean(before), u, history.factor * u};
}

void judge(History& history) {
  const std::vector<std::size_t> dates = dateNumbers(history.values);
  constexpr std::size_t fewest = 3;
  if (dates.back() + 1 == 2) history.twoDates = differenceOf(history, std::ranges::count(dates, 0U));
  if (dates.back() + 1 < fewest) return;
  const CourseEvidence evidence = courseEvidence(scaled(history, dates), history.leastScatter);
  history.courses = evidence.courses;
  const CourseProbability& best = evidence.courses.front();
  if (best.probability < oddsForChange * evidence.of(Course::Constant)) return;
  history.course = best.course;
  if (best.course == Course::Steps) addSteps(history, *evidence.stepping, dates);
  if (best.course == Course::OddValue) history.oddValue = evidence.oddValue;
  if (best.course == Course::Trend) history.scatter = history.trend->u / history.trend->stated;
}

/// Adds the points of the values from `first` to before `end`. The exponentially weighted average of these
/// values begins at the centre line. `centreU`: 0 for values of the baseline.
void addPoints(ControlChart& chart, const std::vector<DatedValue>& values, std::size_t first, std::size_t end,
               double centreU) {
  double ewma = 0, variance = 0, weight = 0;
  for (std::size_t i = first; i < end; ++i) {
    const double off = values[i].value - chart.centre, u = values[i].apart;
    ewma = ewmaWeight * off + (1 - ewmaWeight) * ewma;
    variance = std::pow(ewmaWeight * u, 2) + std::pow(1 - ewmaWeight, 2) * variance;
    weight = ewmaWeight + (1 - ewmaWeight) * weight;
    ControlChart::Point point{.shewhart = limitSigmas * std::hypot(u, centreU),
                              .ewma = chart.centre + ewma,
                              .ewmaLimit = limitSigmas * std::sqrt(variance + std::pow(weight * centreU, 2))};
    point.isOut = std::abs(off) > point.shewhart;
    point.isEwmaOut = std::abs(ewma) > point.ewmaLimit;
    chart.points.push_back(point);
  }
}

}  // namespace

const char* nameOf(Course course) {
  switch (course) {
    case Course::Constant:
      return "constant";
    case Course::Steps:
      return "steps";
    case Course::Trend:
      return "trend";
    case Course::OddValue:
      return "odd_value";
    case Course::Wander:
      return "wander";
  }
  return "";
}

void setBaseline(History& history, std::size_t baseline) {
  constexpr double rangePerSigma = 1.128379167095513;  // 2/√π: mean range of two normal values
  const std::vector<DatedValue>& values = history.values;
  if (baseline == 0 || baseline > values.size()) baseline = values.size();
  const std::vector<DatedValue> first(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(baseline));
  ControlChart chart{.baseline = baseline,
                     .centre = weightedMean(first),
                     .centreU = 1 / std::sqrt(sumOfWeights(first)),
                     .seenSigma = std::numeric_limits<double>::quiet_NaN(),
                     .points = {}};
  addPoints(chart, values, 0, baseline, 0);
  addPoints(chart, values, baseline, values.size(), chart.centreU);
  double ranges = 0;
  for (std::size_t i = 1; i < baseline; ++i) ranges += std::abs(values[i].value - values[i - 1].value);
  if (baseline > 1) chart.seenSigma = ranges / static_cast<double>(baseline - 1) / rangePerSigma;
  history.chart = std::move(chart);
}

History historyOf(std::vector<DatedValue> values, double shared, double coverage) {
  std::ranges::stable_sort(values, {}, &DatedValue::day);
  History history;
  history.coverage = coverage;
  history.factor = normalQuantile((1 + coverage) / 2);
  for (DatedValue& value : values)
    if (!(value.expanded > 0)) value.expanded = history.factor * value.u;
  history.values = std::move(values);
  history.mean.value = weightedMean(history.values);
  const double variance = 1 / sumOfWeights(history.values);
  history.chiSquare = chiSquareAbout(history.values, history.mean.value);
  history.degreesOfFreedom = static_cast<int>(history.values.size()) - 1;
  history.chance = chiSquareUpperTail(history.chiSquare, history.degreesOfFreedom);
  if (history.degreesOfFreedom > 0)
    history.birgeRatio = std::sqrt(history.chiSquare / history.degreesOfFreedom);
  history.scatter = std::max(1.0, history.birgeRatio);
  history.leastScatter = leastScatterOf(history.values);
  history.mean.u = std::sqrt(variance + shared * shared);
  history.mean.expanded = history.factor * history.mean.u;
  history.mean.scattered = std::sqrt(std::pow(history.scatter, 2) * variance + shared * shared);
  history.mean.scatteredExpanded =
      expandedBy(history, history.mean.scattered, history.scatter, history.degreesOfFreedom);
  history.trend = trendOf(history);
  setBaseline(history, 0);
  judge(history);
  if (history.chance) history.stable = *history.chance >= leastChance && history.course == Course::Constant;
  return history;
}

}  // namespace alidade
