#pragma once

#include <optional>
#include <vector>

#include "core/adjustment/result/expected_reading.h"
#include "core/adjustment/result/session_fit.h"
#include "core/session/measurement.h"
#include "core/session/protocol_progress.h"

namespace alidade {

// What the circles will read at the sightings of a protocol: on the arc as fitted so far, else the nominal
// one about the middle of the field, with the orientation of the position's pointing zero, else that of the
// first one known, turned as the protocol turns the circle.

/// Of each sighting of `progress`, as `expectedReadings` has it. Absent where nothing tells: of the first
/// zero, of places before any zero is known, and of places that neither the protocol nor the readings locate.
std::vector<std::optional<ExpectedReading>> forecast(const Measurement& measurement, const SessionFit& fit,
                                                     const SightingProtocol& protocol,
                                                     const ProtocolProgress& progress);

/// Where the slider is to stand, for `expectedReadings`, by the numbers the positions of the protocol have
/// here.
NominalPlaces nominalPlaces(const SightingProtocol& protocol, const std::vector<std::size_t>& positions);

/// The measurement with an arc for each position of the protocol: those it has, and empty ones with the
/// orientation expected. `ArcMeasurement::position` of an empty one that the session lacks counts on behind
/// the session's. Absent where no position has a pointing zero.
struct ProtocolArcs {
  Measurement measurement;
  std::vector<std::size_t> positions;  ///< of each position of the protocol: `ArcMeasurement::position`
};
std::optional<ProtocolArcs> arcsOf(const Measurement& measurement, const SightingProtocol& protocol,
                                   const ProtocolProgress& progress);

}  // namespace alidade
