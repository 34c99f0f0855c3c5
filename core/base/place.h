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

}  // namespace alidade
