#pragma once

#include <optional>
#include <vector>

#include "core/adjustment/result/expected_reading.h"
#include "core/adjustment/result/session_fit.h"
#include "core/session/measurement.h"
#include "core/session/protocol_progress.h"

namespace alidade {

// Expected circle readings at the sightings of a protocol: on the arc fitted so far, else on the nominal arc,
// centred on the pointing zero. The orientation is that of the position's pointing zero. A position without a
// zero has the orientation of the first known zero, turned as the protocol turns the circle.

/// Returns the expected reading of each sighting of `progress`, as `expectedReadings` does. Absent without
/// information: for the first zero, for places before any zero is known, and for places that neither the
/// protocol nor the readings locate.
std::vector<std::optional<ExpectedReading>> forecast(const Measurement& measurement, const SessionFit& fit,
                                                     const SightingProtocol& protocol,
                                                     const ProtocolProgress& progress);

/// The planned places of the slider, for `expectedReadings`. `positions` has the index in the session of each
/// position of the protocol.
NominalPlaces nominalPlaces(const SightingProtocol& protocol, const std::vector<std::size_t>& positions);

/// The measurement with an arc for each position of the protocol: existing arcs, and empty arcs with the
/// expected orientation. If the session lacks the position of an empty arc, its `ArcMeasurement::position`
/// continues the session's numbers. Absent if no position has a pointing zero.
struct ProtocolArcs {
  Measurement measurement;
  std::vector<std::size_t> positions;  ///< `ArcMeasurement::position` of each position of the protocol
};
std::optional<ProtocolArcs> arcsOf(const Measurement& measurement, const SightingProtocol& protocol,
                                   const ProtocolProgress& progress);

}  // namespace alidade
