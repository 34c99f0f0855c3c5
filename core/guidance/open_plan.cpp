#include "core/guidance/open_plan.h"

#include <set>

#include "core/guidance/forecast.h"
#include "core/session/protocol_progress.h"

namespace alidade {

SightingPlan openPlan(const SightingProtocol& protocol) {
  SightingPlan plan{.places = {}, .faces = {}};
  std::set<int> faces, points;
  plan.rows = 0;
  for (const PlannedSighting& planned : sightingsInOrder(listedOrder(protocol))) {
    if (planned.isZero) continue;
    ++plan.rows;
    faces.insert(planned.face);
    points.insert(planned.point);
  }
  plan.faces.assign(faces.begin(), faces.end());
  const std::vector<std::size_t> one(protocol.positions.size(), 0);
  for (const auto& [place, radians] : nominalPlaces(protocol, one))
    if (points.erase(place.second) > 0) plan.places.push_back({place.second, Angle::fromRadians(radians)});
  plan.readsSlider = protocol.readsSlider;
  plan.minutes = protocol.minutes;
  return plan;
}

}  // namespace alidade
