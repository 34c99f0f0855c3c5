#include "tests/bench/speed/measurements.h"

#include "core/simulation/simulate.h"
#include "tests/bench/speed/readings.h"

namespace alidade::bench {

Measurement usualMeasurement(std::size_t arcs) {
  const ArcSetup setup = usualSetup();
  Measurement measurement;
  measurement.distance = setup.distance;
  measurement.nominalRadius = 400;
  measurement.sigmaHorizontal = Angle::fromRadians(setup.sigmaHorizontal);
  measurement.sigmaVertical = Angle::fromRadians(setup.sigmaVertical);
  measurement.sigmaSlider = Angle::fromArcseconds(1);  // as in every session, even without slider readings
  for (std::size_t position = 0; position < arcs; ++position) {
    ArcMeasurement arc;
    arc.position = position;
    arc.axisDeg = position == 0 ? 0 : 180;
    for (std::size_t i = 0; i < pointsOfArc; ++i) {
      Sighting sighting;
      sighting.row = i;
      sighting.sequence = measurement.rows++;
      sighting.point = static_cast<int>(i) + 1;
      sighting.a = Angle::fromRadians(shortArcs().a[position * pointsOfArc + i]);
      sighting.e = Angle::fromRadians(shortArcs().e[position * pointsOfArc + i]);
      arc.sightings.push_back(sighting);
    }
    measurement.arcs.push_back(arc);
  }
  setMoments(measurement);
  return measurement;
}

Measurement fullMeasurement() {
  return examine(*simulate(*protocolByName("full"), drawTruth(1), 1)).measurement.value();
}

}  // namespace alidade::bench
