#include "core/diagnosis/result/sighting_plan.h"

namespace alidade {

SessionEffort effortOf(const Measurement& measurement, const SightingMinutes& minutes) {
  SessionEffort effort{.rows = static_cast<double>(measurement.rows)};
  for (const ArcMeasurement& arc : measurement.arcs) {
    const Sighting* last = nullptr;
    for (const Sighting& sighting : arc.sightings) {
      const bool isElsewhere = !last || last->point != sighting.point || last->round != sighting.round;
      effort.minutes += minutesOf(minutes, {.turnsAxis = !last && &arc != &measurement.arcs.front(),
                                            .sightsZero = !last,
                                            .plungesTelescope = last && last->face != sighting.face,
                                            .drivesSlider = isElsewhere});
      last = &sighting;
    }
  }
  return effort;
}

}  // namespace alidade
