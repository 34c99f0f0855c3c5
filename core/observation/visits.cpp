#include "core/observation/visits.h"

#include <algorithm>
#include <compare>

namespace alidade {

namespace {

/// Are the rounds in ascending order, and the points of each round in one direction? The rows of a visit are
/// then adjacent without sorting.
bool goesOneWay(const std::vector<Sighting>& sightings) {
  std::strong_ordering way = std::strong_ordering::equal;
  for (std::size_t i = 1; i < sightings.size(); ++i) {
    const Sighting &before = sightings[i - 1], &row = sightings[i];
    if (row.round < before.round) return false;
    if (row.round > before.round) way = std::strong_ordering::equal;
    if (row.round > before.round || row.point == before.point) continue;
    const std::strong_ordering step = row.point <=> before.point;
    if (way != std::strong_ordering::equal && way != step) return false;
    way = step;
  }
  return true;
}

/// Indices of the rows, sorted by round and point; the rows of a visit are in ascending order.
std::vector<std::size_t> byRoundAndPoint(const std::vector<Sighting>& sightings) {
  struct Row {
    int round, point;
    std::size_t index;

    auto operator<=>(const Row&) const = default;
  };
  std::vector<Row> rows;
  rows.reserve(sightings.size());
  for (const Sighting& sighting : sightings) rows.push_back({sighting.round, sighting.point, rows.size()});
  std::ranges::sort(rows);
  std::vector<std::size_t> order;
  order.reserve(rows.size());
  for (const Row& row : rows) order.push_back(row.index);
  return order;
}

}  // namespace

std::vector<Visit> visitsOf(const ArcMeasurement& arc) {
  const std::vector<Sighting>& sightings = arc.sightings;
  std::vector<Visit> visits;
  visits.reserve(sightings.size());
  const auto add = [&](std::size_t index) {
    const Sighting& row = sightings[index];
    if (visits.empty() || visits.back().round != row.round || visits.back().point != row.point)
      visits.push_back({row.round, row.point, {}, {}});
    visits.back().sightings.push_back(index);
  };
  if (goesOneWay(sightings)) {
    for (std::size_t i = 0; i < sightings.size(); ++i) add(i);
  } else {
    for (const std::size_t i : byRoundAndPoint(sightings)) add(i);
    std::ranges::sort(visits, {}, [](const Visit& visit) { return visit.sightings.front(); });
  }
  for (Visit& visit : visits) {
    Direction<double> sum{0, 0};
    for (const std::size_t i : visit.sightings) {
      sum.a += sightings[i].a.radians();
      sum.e += sightings[i].e.radians();
    }
    const auto count = static_cast<double>(visit.sightings.size());
    visit.mean = {{sum.a / count, sum.e / count}, static_cast<int>(visit.sightings.size())};
  }
  return visits;
}

const Sighting* sliderOf(const ArcMeasurement& arc, const Visit& visit) {
  for (const std::size_t i : visit.sightings)
    if (arc.sightings[i].slider) return &arc.sightings[i];
  return nullptr;
}

bool hasSliderReadings(const ArcMeasurement& arc) {
  return std::ranges::any_of(arc.sightings, [](const Sighting& s) { return s.slider.has_value(); });
}

}  // namespace alidade
