#include "core/session/row_order.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "core/session/entry.h"
#include "core/session/time_text.h"

namespace alidade {

namespace {

std::optional<int> axisOf(const Position& position) {
  const Result<int> axis = axisEntry(position.axisDeg);
  return axis ? std::optional(*axis) : std::nullopt;
}

/// The time of the first row; absent without rows or without a time.
std::optional<double> beginningOf(const Position& position) {
  return position.readings.empty() ? std::nullopt : minutesOf(position.readings.front().takenAt);
}

}  // namespace

std::vector<std::size_t> positionsAsTaken(const Session& session) {
  std::vector<std::size_t> order(session.positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::map<int, int> repeats;
  bool comesAgain = false;
  for (const Position& position : session.positions)
    if (const auto axis = axisOf(position)) comesAgain = ++repeats[*axis] > 1 || comesAgain;
  if (comesAgain) return order;
  std::vector<std::optional<double>> beginnings;
  for (const Position& position : session.positions) beginnings.push_back(beginningOf(position));
  if (std::ranges::all_of(beginnings, [](const auto& minutes) { return minutes.has_value(); }))
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return *beginnings[i]; });
  else
    std::stable_partition(order.begin(), order.end(),
                          [&](std::size_t i) { return axisOf(session.positions[i]) == 0; });
  return order;
}

std::vector<std::size_t> firstSequences(const Session& session) {
  std::vector<std::size_t> first(session.positions.size());
  std::size_t rows = 0;
  for (const std::size_t i : positionsAsTaken(session)) {
    first[i] = rows;
    rows += session.positions[i].readings.size();
  }
  return first;
}

}  // namespace alidade
