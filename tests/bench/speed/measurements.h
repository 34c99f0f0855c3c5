#pragma once

#include <cstddef>

#include "core/session/measurement.h"

namespace alidade::bench {

/// The first arcs of `shortArcs` as a measurement, at 0° and 180°; zeros and distance exact.
Measurement usualMeasurement(std::size_t arcs);

/// A session of the protocol `full` as simulated: 136 rows in two faces and two rounds, slider readings.
Measurement fullMeasurement();

}  // namespace alidade::bench
