#include "core/series/instrument_check/round_difference.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace alidade {

namespace {

using CommonPairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// Requires both rounds to be in the order of the targets.
CommonPairs commonPairs(const ObservedRound& first, const ObservedRound& second) {
  CommonPairs common;
  std::size_t i = 0, k = 0;
  while (i < first.pairs.size() && k < second.pairs.size()) {
    const std::size_t one = first.pairs[i].target, two = second.pairs[k].target;
    if (one == two) common.emplace_back(i, k);
    if (one <= two) ++i;
    if (two <= one) ++k;
  }
  return common;
}

/// The index of the value farthest from the lower median, and its distance from it, degrees, ≥ 0. The lower
/// median is one of the values; the mean of two would halve their difference.
std::pair<std::size_t, double> farthest(const std::vector<Angle>& values) {
  std::vector<double> degrees;
  degrees.reserve(values.size());
  for (const Angle value : values) degrees.push_back(wrapped(value - values.front()).degrees());
  std::vector<double> sorted = degrees;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const auto distance = [&](std::size_t i) {
    return std::abs(wrapped(Angle::fromDegrees(degrees[i] - *middle)).degrees());
  };
  std::size_t most = 0;
  for (std::size_t i = 1; i < degrees.size(); ++i)
    if (distance(i) > distance(most)) most = i;
  return {most, distance(most)};
}

}  // namespace

std::size_t commonTargets(const ObservedRound& first, const ObservedRound& second) {
  return commonPairs(first, second).size();
}

std::optional<RoundDifference> differenceOf(const ObservedRound& first, const ObservedRound& second,
                                            Angle most) {
  const CommonPairs common = commonPairs(first, second);
  if (common.empty()) return std::nullopt;
  std::vector<Angle> turns, sums;
  RoundDifference vertical{.isVertical = true};
  for (const auto& [i, k] : common) {
    const FacePair &one = first.pairs[i], &two = second.pairs[k];
    turns.push_back(two.direction - one.direction);
    sums.push_back(two.direction + one.direction);
    const Angle by = Angle::fromDegrees(std::abs(wrapped(two.vertical - one.vertical).degrees()));
    if (by.degrees() > vertical.by.degrees()) vertical = {i, k, by, true, false};
  }
  const auto [target, degrees] = farthest(turns);
  const bool isElsewhere = degrees > most.degrees(), isHigher = vertical.by.degrees() > most.degrees();
  if (!isElsewhere && !isHigher) return std::nullopt;
  const bool isReversed = isElsewhere && !isHigher && farthest(sums).second <= most.degrees();
  if (vertical.by.degrees() > degrees) return vertical;
  return RoundDifference{common[target].first, common[target].second, Angle::fromDegrees(degrees), false,
                         isReversed};
}

}  // namespace alidade
