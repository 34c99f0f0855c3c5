#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/angle.h"
#include "core/base/result.h"
#include "core/session/json_origin.h"
#include "core/session/session.h"
#include "core/session/sighting_minutes.h"

namespace alidade {

// A measurement protocol: the sightings of a session, their number and order. It is a separate file,
// `*.alidade-protocol`, or the `protocol` of a session that follows it. A session has one orientation of the
// horizontal circle per position: turning the circle between two rounds begins a repeat of the position, with
// its own pointing zero.

/// A place of the slider. The arc angle refers to axis position 0°, counter-clockwise from the right as the
/// observer sees it; if it is empty, the slider coordinate replaces it.
struct ProtocolPlace {
  int point = 1;            ///< ≥ 0; identifies the place in the session
  std::string slider = {};  ///< coordinate to set the slider to, as typed; may be empty
  std::string arc = {};     ///< nominal arc angle, as typed; may be empty
  JsonOrigin origin = {};

  bool operator==(const ProtocolPlace&) const = default;
};

/// One run through all places: a round of the session.
struct ProtocolRound {
  bool isBack = false;  ///< the round goes from the last place to the first
  /// The faces in the order of pointing, while the slider is at rest: one face, both, or both twice. In the
  /// last case every other place uses the second pair: 1 2 2 1 saves turning the telescope over.
  std::vector<int> faces = {1};
  JsonOrigin origin = {};

  bool operator==(const ProtocolRound&) const = default;
};

/// The faces in which the pointing zero is sighted, in the order of pointing.
struct ProtocolZeros {
  std::vector<int> before = {1}, after = {};  ///< before and after the readings; `before` always
                                              ///< contains face 1
  JsonOrigin origin = {};

  bool operator==(const ProtocolZeros&) const = default;
};

struct ProtocolPosition {
  int axisDeg = 0;  ///< 0 or 180; a further position with the same value is a repeat
  /// Rotation of the horizontal circle relative to its first orientation, as typed; empty: none.
  std::string circleTurn = {};
  ProtocolZeros zeros = {};
  std::vector<ProtocolPlace> places = {};  ///< places of this position; empty: those of the protocol
  std::vector<ProtocolRound> rounds = {{}};
  JsonOrigin origin = {};

  bool operator==(const ProtocolPosition&) const = default;
};

struct SightingProtocol {
  std::string name = {}, description = {};
  bool readsSlider = false;  ///< the slider is read at each place
  /// Within a position, the next sighting is the most informative one per minute, and the axis is turned when
  /// that is more informative. False: the sightings have a fixed order.
  bool isByWorth = false;
  /// Nobody chose the protocol: it applies only as long as the rows of the session follow it.
  bool isYielding = false;
  SightingMinutes minutes = {};  ///< costs of a sighting if `isByWorth`
  std::vector<ProtocolPlace> places = {};
  std::vector<ProtocolPosition> positions = {};
  JsonOrigin origin = {};

  bool operator==(const SightingProtocol&) const = default;

  const std::vector<ProtocolPlace>& placesOf(const ProtocolPosition& position) const {
    return position.places.empty() ? places : position.places;
  }
};

/// Limit of sightings in a protocol: more than anyone takes by hand.
inline constexpr std::size_t mostSightings = 10'000;

/// The protocol by worth. Within `mostSightings`, it has every position twice: the axis can turn back.
SightingProtocol openOrder(SightingProtocol protocol);
/// The protocol in its order again, without what `openOrder` added.
SightingProtocol listedOrder(SightingProtocol protocol);

/// The number of sightings of places and of pointing zeros.
std::size_t sightingCount(const SightingProtocol& protocol);

/// Reads the text of a `*.alidade-protocol` file (JSON, UTF-8, format version 1). Fails, with the place, as
/// `readSession` does and on every invalid entry.
Result<SightingProtocol> readProtocol(std::string_view text);
/// The protocol as the text of a file, ending in a newline. Unknown keys are preserved.
std::string writeProtocol(const SightingProtocol& protocol);
/// Reads a protocol from a file; the problem says why the file cannot be opened, or what is wrong in it.
Result<SightingProtocol> loadProtocol(const std::string& path);

/// The protocol in the text of a session; absent without one. Fails, with the place, if it is invalid.
Result<std::optional<SightingProtocol>> statedProtocol(const Session& session);
/// The text for `Session::protocol`.
std::string protocolText(const SightingProtocol& protocol);

/// The coordinate s of the slider at a place, if the protocol states it: from the nominal arc angle, else
/// from the slider coordinate.
std::optional<Angle> nominalPlace(const ProtocolPlace& place);
/// Rotation of a position's circle relative to its orientation in the first position; 0 if none is stated.
Angle circleTurn(const ProtocolPosition& position);

}  // namespace alidade
