#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/diagnosis/next_sighting.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/sighting_plan.h"
#include "core/diagnosis/sightings_ahead.h"
#include "core/session/measurement.h"
#include "core/session/protocol_progress.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

/// The next sighting of a protocol by worth (`isByWorth`), and whether the sightings so far are enough.
struct SightingChoice {
  enum class Reason {
    MostInformative,
    EarlyPlace,   ///< the first place of the position once more, so that an effect of time shows
    ClosingZero,  ///< the pointing zero after the readings, for the same purpose
  };

  std::size_t next = 0;  ///< index into the progress; if the axis turns, of the new zero
  Reason reason = Reason::MostInformative;
  NextSighting worth;  ///< of the next sighting; meaningful only for `MostInformative`
  std::vector<std::size_t> alternatives = {};  ///< indices of nearly as valuable sightings, at most two
  SessionSoFar soFar;
};

/// The plan of all places of a protocol with all faces of its rounds. `SightingPlan::rows`, to whose duration
/// a stated drift refers, excludes the sightings that `openOrder` added.
SightingPlan openPlan(const SightingProtocol& protocol);

/// Most sightings of a session for which choices are made. The time of a choice grows with their square.
inline constexpr std::size_t mostForChoice = 400;

/// Chooses among the sightings left in the position of the last reading and in the next position at the other
/// axis angle. If that next position already has a zero, only its sightings remain. Place and face are
/// chosen; the round is the first one left. Absent before the first reading, above `mostForChoice`, while the
/// pointing zero is missing, and if no sighting is left: then the order of the protocol holds.
std::optional<SightingChoice> chooseSighting(const Measurement& measurement, const SightingProtocol& protocol,
                                             const ProtocolProgress& progress);

/// In a protocol by worth, chooses and lets `progress` point to the choice. Absent in another protocol.
std::optional<SightingChoice> followChoice(const Session& session, const Measurement& measurement,
                                           const SightingProtocol& protocol, ProtocolProgress& progress);

/// The sightings at the places of a protocol by worth that reach this U of Δd, mm (`sightingsFor`). Absent in
/// another protocol, before the first reading, and above `mostForChoice`. The noise is that of the diagnosis
/// of the measurement; with a null diagnosis, the stated noise.
std::optional<SightingsAhead> sightingsAhead(const Measurement& measurement, const SightingProtocol& protocol,
                                             double uncertainty, const Diagnosis* diagnosis,
                                             const std::stop_token& stop = {});

}  // namespace alidade
