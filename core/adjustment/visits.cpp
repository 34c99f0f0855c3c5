#include "core/adjustment/visits.h"

#include <algorithm>
#include <compare>

namespace alidade {

std::vector<Visit> visitsOf(const ArcMeasurement& arc) {
  struct Row {
    int round, point;
    std::size_t index;

    auto operator<=>(const Row&) const = default;
  };
  std::vector<Row> rows;
  rows.reserve(arc.sightings.size());
  for (const Sighting& sighting : arc.sightings)
    rows.push_back({sighting.round, sighting.point, rows.size()});
  if (!std::ranges::is_sorted(rows)) std::ranges::sort(rows);
  std::vector<Visit> visits;
  visits.reserve(rows.size());
  for (const Row& row : rows) {
    if (visits.empty() || visits.back().round != row.round || visits.back().point != row.point)
      visits.push_back({row.round, row.point, {}, {}});
    visits.back().sightings.push_back(row.index);
  }
  const auto firstRow = [](const Visit& visit) { return visit.sightings.front(); };
  if (!std::ranges::is_sorted(visits, {}, firstRow)) std::ranges::sort(visits, {}, firstRow);
  for (Visit& visit : visits) {
    Direction<double> sum{0, 0};
    for (const std::size_t i : visit.sightings) {
      sum.a += arc.sightings[i].a.radians();
      sum.e += arc.sightings[i].e.radians();
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

}  // namespace alidade
