#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace alidade {

/// A place in a session, by the names of the session file. Indices count from 0. {.position = 1, .reading =
/// 3, .field = "vertical"} is `positions[1].readings[3].vertical`, {.position = 1, .field =
/// "pointing_zero.vertical"} is `positions[1].pointing_zero.vertical`, {.field = "geometry.distance_mm"} is
/// `geometry.distance_mm`. An empty place is the session as a whole.
struct Place {
  std::optional<std::size_t> position = {};
  std::optional<std::size_t> reading = {};  ///< only together with `position`
  std::string field = {};

  std::string path() const;

  bool operator==(const Place&) const = default;
};

/// The reason why an input cannot be used: one sentence with the error and the remedy, and the place in the
/// session.
struct Problem {
  std::string what;  ///< e.g. `“88°71'49"” has 71 minutes; minutes go from 0 to 59`
  Place where = {};

  /// `positions[1].readings[3].vertical: …`, or only the sentence if there is no place.
  std::string text() const;

  bool operator==(const Problem&) const = default;
};

}  // namespace alidade
