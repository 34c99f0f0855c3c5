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

namespace alidade {

// A measurement protocol: what is sighted in a session, how often and in which order. A file of its own,
// `*.alidade-protocol`, or the `protocol` of a session that follows it. A session has one orientation of the
// horizontal circle for each of its positions, so a circle that is turned between two rounds makes a position
// measured again, with its own pointing zero.

/// A place of the slider. The arc angle is that of axis position 0°, counter-clockwise from the right as the
/// observer sees it; where it is empty the slider coordinate stands for it.
struct ProtocolPlace {
  int point = 1;            ///< ≥ 0; names the place in the session
  std::string slider = {};  ///< coordinate to which the slider is brought, as typed; may be empty
  std::string arc = {};     ///< nominal arc angle, as typed; may be empty
  JsonOrigin origin = {};

  bool operator==(const ProtocolPlace&) const = default;
};

/// One run through all places: a round of the session.
struct ProtocolRound {
  bool isBack = false;  ///< from the last place to the first
  /// In the order of pointing, while the slider stands still: one face, both, or both twice, the second pair
  /// at every other place: 1 2 2 1 spares turning the telescope over.
  std::vector<int> faces = {1};
  JsonOrigin origin = {};

  bool operator==(const ProtocolRound&) const = default;
};

/// In which faces the pointing zero is sighted, in the order of pointing.
struct ProtocolZeros {
  std::vector<int> before = {1}, after = {};  ///< of the readings; `before` holds face 1, on which all rests
  JsonOrigin origin = {};

  bool operator==(const ProtocolZeros&) const = default;
};

struct ProtocolPosition {
  int axisDeg = 0;  ///< 0 or 180; one that comes again is measured again
  /// By how much the horizontal circle is turned against its first orientation, as typed; empty: not at all.
  std::string circleTurn = {};
  ProtocolZeros zeros = {};
  std::vector<ProtocolPlace> places = {};  ///< its own; empty: those of the protocol
  std::vector<ProtocolRound> rounds = {{}};
  JsonOrigin origin = {};

  bool operator==(const ProtocolPosition&) const = default;
};

struct SightingProtocol {
  std::string name = {}, description = {};
  bool readsSlider = false;  ///< the slider is read at each place
  std::vector<ProtocolPlace> places = {};
  std::vector<ProtocolPosition> positions = {};
  JsonOrigin origin = {};

  bool operator==(const SightingProtocol&) const = default;

  const std::vector<ProtocolPlace>& placesOf(const ProtocolPosition& position) const {
    return position.places.empty() ? places : position.places;
  }
};

/// A protocol holds no more of them: more than anybody sights by hand.
inline constexpr std::size_t mostSightings = 10'000;

/// Of the places and of the pointing zeros.
std::size_t sightingCount(const SightingProtocol& protocol);

/// Reads the text of a `*.alidade-protocol` file (JSON, UTF-8, format version 1). Fails, with the place, on
/// what `readSession` fails on and on every entry that means nothing.
Result<SightingProtocol> readProtocol(std::string_view text);
/// The protocol as the text of a file, ending in a newline. Unknown keys survive.
std::string writeProtocol(const SightingProtocol& protocol);
/// Reads a protocol from a file; the sentence names the file's trouble where it cannot be opened.
Result<SightingProtocol> loadProtocol(const std::string& path);

/// The protocol that a session follows; nothing where it follows none. Fails, with the place in the session.
Result<std::optional<SightingProtocol>> protocolOf(const Session& session);
/// As `Session::protocol` keeps it.
std::string protocolText(const SightingProtocol& protocol);

/// The coordinate s of the slider at a place, where the protocol says it: its nominal arc angle, else its
/// slider coordinate.
std::optional<Angle> nominalPlace(const ProtocolPlace& place);
/// Of the circle of a position against that of the first.
Angle circleTurn(const ProtocolPosition& position);

}  // namespace alidade
