#include "core/base/histogram.h"

#include <algorithm>
#include <cmath>

#include "core/base/round_numbers.h"
#include "core/base/statistics.h"

namespace alidade {
namespace {

constexpr double mostClasses = 60;  // at most, before the width is rounded and the ends are completed

/// The range of the middle half of the values.
double interquartileRange(std::span<const double> values) {
  if (values.empty()) return 0;
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  const std::size_t last = sorted.size() - 1;
  return sorted[last - last / 4] - sorted[last / 4];
}

double below(double z) {
  return studentLowerTail(z, DegreesOfFreedom::infinite()).value_or(0);
}

}  // namespace

std::optional<std::size_t> Histogram::classOf(double value) const {
  if (counts.empty() || !(value >= first && value <= end())) return {};
  return std::min(static_cast<std::size_t>((value - first) / width), counts.size() - 1);
}

std::size_t Histogram::largestCount() const {
  return counts.empty() ? 0 : std::ranges::max(counts);
}

Histogram histogram(std::span<const double> values, double reach) {
  const double wanted = 2 * interquartileRange(values) /
                        std::cbrt(static_cast<double>(std::max<std::size_t>(values.size(), 1)));
  Histogram histogram;
  histogram.width = roundUp125(std::max(wanted, 2 * reach / mostClasses));
  constexpr double slack = 1e-9;  // makes 5.0000000001 classes count as 5
  const double onEachSide = std::max(1.0, std::ceil(reach / histogram.width - slack));
  histogram.first = -onEachSide * histogram.width;
  histogram.counts.resize(2 * static_cast<std::size_t>(onEachSide));
  for (const double value : values)
    ++(histogram.classOf(value) ? histogram.counts[*histogram.classOf(value)] : histogram.outside);
  return histogram;
}

double expectedBetween(std::span<const NormalValues> values, double lower, double upper) {
  double expected = 0;
  for (const NormalValues& one : values)
    expected += static_cast<double>(one.count) * (below(upper / one.sigma) - below(lower / one.sigma));
  return expected;
}

}  // namespace alidade
