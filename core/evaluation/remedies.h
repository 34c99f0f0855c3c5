#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/base/problem.h"
#include "core/evaluation/gap.h"

namespace alidade {

// Remedies for causes that no effect of the model describes.

/// Rows of one position.
struct RowRange {
  std::size_t position = 0, first = 0, count = 0;
};

/// A jump of the orientation within a position.
struct Jump {
  Place place;            ///< the first row after the jump
  bool isLast = false;    ///< no position was read after the position of the jump
  bool isAtZero = false;  ///< the jump is between the position's pointing zero and its first sighting
  /// The rows before and the rows after the jump, each present if the other rows suffice for an arc. `before`
  /// also requires a later position and one pointing zero for all positions.
  std::optional<RowRange> before = {}, after = {};
};

/// The jump that a cause describes; absent if the cause is not a jump.
std::optional<Jump> jumpOf(const Gap& gap, const Cause& cause);

/// σ of both circles, arcseconds, as they would be typed.
struct StatedNoise {
  std::string horizontal, vertical;
};

/// The stated σ of both circles times the ratio of noise found, rounded to two significant digits. Absent if
/// the cause is not larger noise.
std::optional<StatedNoise> scatterOf(const Gap& gap, const Cause& cause);

}  // namespace alidade
