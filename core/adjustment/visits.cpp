#include "core/adjustment/visits.h"

#include <map>
#include <utility>

namespace alidade {

std::vector<Visit> visitsOf(const ArcMeasurement& arc) {
  std::vector<Visit> visits;
  std::map<std::pair<int, int>, std::size_t> known;
  for (std::size_t i = 0; i < arc.sightings.size(); ++i) {
    const Sighting& sighting = arc.sightings[i];
    const auto [entry, isNew] = known.try_emplace({sighting.round, sighting.point}, visits.size());
    if (isNew) visits.push_back({sighting.round, sighting.point, {}, {}});
    visits[entry->second].sightings.push_back(i);
  }
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

}  // namespace alidade
