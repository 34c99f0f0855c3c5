#include "core/series/history/course_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace alidade {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Accumulates the logarithm of a sum of exponentials.
class LogSum {
 public:
  void add(double log) {
    if (log == -infinite) return;
    if (log > m_largest) {
      m_sum = m_sum * std::exp(m_largest - log) + 1;
      m_largest = log;
    } else {
      m_sum += std::exp(log - m_largest);
    }
  }
  double log() const { return m_sum > 0 ? m_largest + std::log(m_sum) : -infinite; }

 private:
  double m_largest = -infinite, m_sum = 0;
};

/// Log prior density of the size of a change, in units of ū, at noise s.
double logCauchy(double size, double s) {
  constexpr double scale = 3;
  const double width = scale * s;
  return -std::log(std::numbers::pi * width * (1 + size * size / (width * width)));
}

struct Noise {
  double s = 1, logPrior = 0;
};

/// A grid of s, fine enough for some thousand values, up to where the evidence is negligible.
std::vector<Noise> noiseGrid(double birge, std::size_t count, double least) {
  constexpr double asStated = 0.7;
  const double step = std::min(0.1, 1 / std::sqrt(static_cast<double>(count)));
  const double largest = std::log(std::max(3.0, 3 * birge)), smallest = std::log(least);
  const double below = std::floor(-smallest / step);  // points of the grid below 1
  const double share = std::log(asStated / (below + 1));
  std::vector<Noise> grid;
  for (double i = below; i > 0; --i) grid.push_back({std::exp(-i * step), share});
  grid.push_back({1, std::log(asStated / (below + 1) + (1 - asStated) * (1 - std::exp(-step / 2)))});
  for (double log = step; log <= largest; log += step)
    grid.push_back({std::exp(log), std::log((1 - asStated) * 2 * std::sinh(step / 2)) - log});
  return grid;
}

class Evidence {
 public:
  Evidence(const std::vector<ScaledValue>& values, double leastScatter)
      : m_leastScatter(leastScatter),
        m_values(values),
        m_dates(sumsOf(values)),
        m_all(m_dates.between(0, m_dates.count())) {
    m_chiSquare = m_all.chiSquare();
    m_noise = noiseGrid(std::sqrt(m_chiSquare / freedom(0)), values.size(), leastScatter);
  }

  CourseEvidence all() {
    CourseEvidence evidence;
    const double steps = ofSteps(evidence);
    const double odd = ofOddValue(evidence);
    evidence.courses = {{Course::Constant, std::log(0.5) + ofConstant()},
                        {Course::Steps, std::log(0.25) + steps},
                        {Course::Trend, std::log(0.125) + ofTrend()},
                        {Course::OddValue, std::log(0.0625) + odd},
                        {Course::Wander, std::log(0.0625) + ofWander()}};
    LogSum sum;
    for (const CourseProbability& course : evidence.courses) sum.add(course.probability);
    for (CourseProbability& course : evidence.courses)
      course.probability = std::exp(course.probability - sum.log());
    std::ranges::stable_sort(evidence.courses, std::greater{}, &CourseProbability::probability);
    return evidence;
  }

 private:
  double m_leastScatter;
  const std::vector<ScaledValue>& m_values;
  DateSums m_dates;
  WeightedSums m_all;
  double m_chiSquare = 0;
  std::vector<Noise> m_noise;

  static std::vector<WeightedSums> sumsOf(const std::vector<ScaledValue>& values) {
    std::vector<WeightedSums> dates;
    for (const ScaledValue& value : values) {
      dates.resize(std::max(dates.size(), value.date + 1));
      const double w = 1 / (value.u * value.u);
      dates[value.date] += {w, w * value.x, w * value.x * value.x};
    }
    return dates;
  }

  double freedom(std::size_t changes) const {
    return static_cast<double>(m_values.size()) - 1 - static_cast<double>(changes);
  }

  /// Log of Σ over s of prior · s^−(n−1) exp(−χ²/2s²) · exp(extra(s)).
  template <class Extra>
  double overNoise(double chiSquare, const Extra& extra) const {
    LogSum sum;
    for (const Noise& noise : m_noise)
      sum.add(noise.logPrior - freedom(0) * std::log(noise.s) - chiSquare / (2 * noise.s * noise.s) +
              extra(noise.s));
    return sum.log();
  }

  double ofConstant() const {
    return overNoise(m_chiSquare, [](double) { return 0.0; });
  }

  /// Log evidence of one change: `size`, its `sigma` at s = 1, and the χ² that remains with the change.
  double ofChange(double chiSquare, double size, double sigma) const {
    const double room = std::log(std::sqrt(2 * std::numbers::pi) * sigma);
    return overNoise(chiSquare, [&](double s) { return room + std::log(s) + logCauchy(size, s); });
  }

  double ofTrend() const {
    double wt = 0;
    for (const ScaledValue& value : m_values) wt += value.years / (value.u * value.u);
    const double middle = wt / m_all.w;
    double tt = 0, tx = 0;
    for (const ScaledValue& value : m_values) {
      const double t = value.years - middle, w = 1 / (value.u * value.u);
      tt += w * t * t;
      tx += w * t * (value.x - m_all.mean());
    }
    const double span = m_values.back().years - m_values.front().years;
    return ofChange(std::max(0.0, m_chiSquare - tx * tx / tt), span * tx / tt, span / std::sqrt(tt));
  }

  double ofOddValue(CourseEvidence& evidence) const {
    LogSum sum;
    double best = -infinite;
    for (std::size_t i = 0; i < m_values.size(); ++i) {
      const double w = 1 / (m_values[i].u * m_values[i].u), rest = m_all.w - w;
      if (!(rest > 0)) continue;
      const double size = m_values[i].x - (m_all.wx - w * m_values[i].x) / rest;
      const double variance = 1 / w + 1 / rest;
      const double log =
          ofChange(std::max(0.0, m_chiSquare - size * size / variance), size, std::sqrt(variance));
      if (log > best) {
        best = log;
        evidence.oddValue = i;
      }
      sum.add(log);
    }
    return sum.log() - std::log(static_cast<double>(m_values.size()));
  }

  /// χ² for each possible first date after this step, with the other steps fixed.
  std::vector<double> movedChiSquares(const Stepping& stepping, std::size_t step) const {
    const std::size_t begin = step == 0 ? 0 : stepping.firsts[step - 1];
    const std::size_t end = step + 1 < stepping.firsts.size() ? stepping.firsts[step + 1] : m_dates.count();
    std::vector<double> moved(m_dates.count(), infinite);
    const double here = m_dates.between(begin, stepping.firsts[step]).chiSquare() +
                        m_dates.between(stepping.firsts[step], end).chiSquare();
    for (std::size_t first = begin + 1; first < end; ++first)
      moved[first] = stepping.chiSquare - here + m_dates.between(begin, first).chiSquare() +
                     m_dates.between(first, end).chiSquare();
    return moved;
  }

  double ofStepping(const Stepping& stepping, const std::vector<std::vector<double>>& moved) const {
    std::vector<double> sizes;
    double logLevels = std::log(m_all.w);
    for (std::size_t i = 0, begin = 0; i <= stepping.firsts.size(); ++i) {
      const std::size_t end = i < stepping.firsts.size() ? stepping.firsts[i] : m_dates.count();
      const WeightedSums level = m_dates.between(begin, end);
      logLevels -= std::log(level.w);
      if (i > 0)
        sizes.push_back(level.mean() - m_dates.between(i > 1 ? stepping.firsts[i - 2] : 0, begin).mean());
      begin = end;
    }
    const double k = static_cast<double>(sizes.size());
    const double room = logLevels / 2 + k * std::log(2 * std::numbers::pi) / 2;
    return overNoise(stepping.chiSquare,
                     [&](double s) {
                       double extra = room + k * std::log(s);
                       for (const double size : sizes) extra += logCauchy(size, s);
                       for (const std::vector<double>& places : moved) {
                         double sum = 0;
                         for (const double chiSquare : places)
                           sum += std::exp((stepping.chiSquare - chiSquare) / (2 * s * s));
                         extra += std::log(sum);
                       }
                       return extra;
                     }) -
           logWays(sizes.size());
  }

  /// Log of the number of ways to place this many steps.
  double logWays(std::size_t steps) const {
    const double places = static_cast<double>(m_dates.count() - 1), k = static_cast<double>(steps);
    return std::lgamma(places + 1) - std::lgamma(k + 1) - std::lgamma(places - k + 1);
  }

  /// Adds steps until three numbers of steps in a row are less probable than the best number.
  double ofSteps(CourseEvidence& evidence) const {
    constexpr std::size_t mostSteps = 30, patience = 3;
    StepSearch search(m_dates);
    LogSum sum;
    double best = -infinite;
    std::size_t worse = 0;
    const std::size_t most = std::min({mostSteps, m_dates.count() - 1, m_values.size() - 2});
    for (std::size_t steps = 1; steps <= most && worse < patience; ++steps) {
      SteppingEvidence found{search.next(), {}};
      std::vector<std::vector<double>> moved;
      for (std::size_t step = 0; step < steps; ++step) moved.push_back(movedChiSquares(found.stepping, step));
      const double log =
          ofStepping(found.stepping, moved) - static_cast<double>(steps) * std::log(4.0) + std::log(3.0);
      sum.add(log);
      if (++worse; log > best) {
        best = log;
        worse = 0;
        found.places = placesOf(found.stepping, std::move(moved));
        evidence.stepping = std::move(found);
      }
    }
    return sum.log();
  }

  std::vector<std::vector<double>> placesOf(const Stepping& stepping,
                                            std::vector<std::vector<double>> moved) const {
    const double left = freedom(stepping.firsts.size());
    const double least = m_leastScatter * m_leastScatter;
    const double variance = left > 0 ? std::max(least, stepping.chiSquare / left) : 1;
    for (std::vector<double>& places : moved) {
      double sum = 0;
      for (double& place : places) sum += place = std::exp((stepping.chiSquare - place) / (2 * variance));
      for (double& place : places) place /= sum;
    }
    return moved;
  }

  /// Log evidence of wandering, by a Kalman filter with an unknown first level. Like the evidence of the
  /// other courses, it is relative to a constant level at s = 1 with zero residuals.
  double ofWander() const {
    constexpr double finest = 0.3, ratio = 1.5;
    const double coarsest = std::max(30.0, 3 * std::sqrt(m_chiSquare / m_all.w));
    const double base = wandering(0, 1) + m_chiSquare / 2;
    LogSum sum;
    constexpr std::size_t stride = 3;  // every third s suffices, as wandering is smooth in s
    for (std::size_t i = 0; i < m_noise.size(); i += stride) {
      LogSum within;
      for (std::size_t j = i; j < std::min(i + stride, m_noise.size()); ++j) within.add(m_noise[j].logPrior);
      const double s = m_noise[i].s;
      for (double size = finest * s; size <= coarsest * s; size *= ratio)
        sum.add(within.log() + wandering(size, s) - base + std::log(2.0) + logCauchy(size, s) +
                std::log(size * std::log(ratio)));
    }
    return sum.log();
  }

  double wandering(double overAll, double s) const {
    const double span = m_values.back().years - m_values.front().years;
    double log = 0, level = 0, variance = infinite, years = m_values.front().years;
    for (const ScaledValue& value : m_values) {
      const double noise = s * s * value.u * value.u;
      if (variance == infinite) {
        level = value.x;
        variance = noise;
        continue;
      }
      variance += overAll * overAll * (value.years - years) / span;
      years = value.years;
      const double total = variance + noise, off = value.x - level;
      log -= (std::log(total) + off * off / total) / 2;
      level += variance / total * off;
      variance *= noise / total;
    }
    return log;
  }
};

}  // namespace

double CourseEvidence::of(Course course) const {
  const auto found = std::ranges::find(courses, course, &CourseProbability::course);
  return found == courses.end() ? 0 : found->probability;
}

CourseEvidence courseEvidence(const std::vector<ScaledValue>& values, double leastScatter) {
  return Evidence(values, leastScatter).all();
}

}  // namespace alidade
