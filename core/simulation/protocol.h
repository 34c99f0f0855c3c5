#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/angle.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

/// The faces that are read.
enum class FacePlan {
  FaceOne,
  BothAtEachPlace,  ///< face 1, then face 2, with the slider at rest
  Alternating,      ///< odd rounds in face 1, even rounds in face 2
};

/// A plan of readings: their number and order.
///
/// In each position the slider moves forward through its places in odd rounds and back in even ones.
struct Protocol {
  std::string name;
  std::string description;
  int points = 17;                       ///< places of the slider in a round, ≥ 1
  Angle first = Angle::fromDegrees(10);  ///< slider coordinate of the first place
  Angle step = Angle::fromDegrees(10);   ///< from place to place
  int rounds = 1;                        ///< ≥ 1
  FacePlan faces = FacePlan::FaceOne;
  bool slider = false;               ///< the slider is read, once at each place
  std::vector<int> axes = {0, 180};  ///< axis angles of the positions in order, degrees: 0 or 180
  Angle circleShift = {};            ///< turn of the horizontal circle between the positions
};

/// One pointing of a protocol.
struct PlannedRow {
  int round = 1, point = 1, face = 1;

  bool operator==(const PlannedRow&) const = default;
};

/// The rows of one position in the order in which they are taken; point 1 is at `first`.
std::vector<PlannedRow> plannedRows(const Protocol& protocol);

/// The slider coordinate planned for a point, counted from 1.
Angle plannedPlace(const Protocol& protocol, int point);

/// The named protocols.
std::span<const Protocol> namedProtocols();

/// Null if the name is unknown.
const Protocol* protocolByName(std::string_view name);

/// The readings of `simulate` for a plan, in the same order, as a protocol that a session can follow. The
/// zeros are sighted in face 1, and also in face 2 if both faces are read.
SightingProtocol templateOf(const Protocol& protocol);

/// The protocol of a new session. It applies only until a row of the session departs from it (`isYielding`).
/// It has the points of `paper` without slider coordinates, since these differ from device to device.
SightingProtocol usualProtocol();

/// Finds a template by its name in `simulate --protocol`; absent if the name is unknown.
std::optional<SightingProtocol> templateNamed(std::string_view name);

}  // namespace alidade
