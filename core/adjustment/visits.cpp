#include "core/adjustment/visits.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace alidade {

std::vector<Visit> visitsOf(const ArcMeasurement& arc) {
  const auto keyOf = [&](std::size_t i) {
    return std::tuple(arc.sightings[i].round, arc.sightings[i].point, i);
  };
  std::vector<std::size_t> order(arc.sightings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, keyOf);
  std::vector<Visit> visits;
  visits.reserve(order.size());
  for (const std::size_t i : order) {
    const Sighting& sighting = arc.sightings[i];
    if (visits.empty() || visits.back().round != sighting.round || visits.back().point != sighting.point)
      visits.push_back({sighting.round, sighting.point, {}, {}});
    visits.back().sightings.push_back(i);
  }
  std::ranges::sort(visits, {}, [](const Visit& visit) { return visit.sightings.front(); });
  for (Visit& visit : visits) {
    Direction<double> sum{0, 0};
    for (const std::size_t i : visit.sightings) {
      sum.a += arc.sightings[i].a.radians();
      sum.e += arc.sightings[i].e.radians();
    }
    const auto rows = static_cast<double>(visit.sightings.size());
    visit.mean = {{sum.a / rows, sum.e / rows}, static_cast<int>(visit.sightings.size())};
  }
  return visits;
}

const Sighting* sliderOf(const ArcMeasurement& arc, const Visit& visit) {
  for (const std::size_t i : visit.sightings)
    if (arc.sightings[i].slider) return &arc.sightings[i];
  return nullptr;
}

}  // namespace alidade
