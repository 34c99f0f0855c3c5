#pragma once

#include <cstddef>

namespace alidade {

/// The sightings on which a jump of the orientation acts, by their order in the session (`Sighting::order`).
struct JumpMoment {
  static constexpr std::size_t never = static_cast<std::size_t>(-1);

  std::size_t first = 0;    ///< the first row after the jump
  std::size_t end = never;  ///< the first row on which the jump no longer acts; `never`: none

  bool operator==(const JumpMoment&) const = default;
  bool actsOn(std::size_t row) const { return row >= first && row < end; }
};

}  // namespace alidade
